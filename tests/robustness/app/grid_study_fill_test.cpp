// Sizes that a grid study fills in between its coarse ones, as a user meets them.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "program.h"

namespace tw::test {
namespace grid_study_fill_test {

const std::string column = falling_column("column", "duration = 0.1", "[0.4, 0.1, 0.02]");

struct PlannedLine {
    std::string run, state;
    std::string together;  // [s]
};
/// The rows of the table that --plan prints.
std::vector<PlannedLine> lines_of(const std::string& plan) {
    std::vector<PlannedLine> lines;
    std::istringstream text(plan);
    for (std::string line; std::getline(text, line);) {
        if (line.find("| SPH at") != 0) continue;
        std::vector<std::string> cells;
        std::istringstream row(line);
        for (std::string cell; std::getline(row, cell, '|');) {
            const auto from = cell.find_first_not_of(' '), to = cell.find_last_not_of(' ');
            cells.push_back(from == cell.npos ? "" : cell.substr(from, to - from + 1));
        }
        lines.push_back({cells.at(1), cells.at(5), cells.at(4)});
    }
    return lines;
}

TEST_F(Command, AGridStudyFillsInBetweenItsCoarseSizesBehindAllOthers) {
    write("column.toml", column);
    const auto plan = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"ladder", "column.toml", "--no-variations", "--plan"});
        std::string runs;
        for (const PlannedLine& line : lines_of(twinwake(more).out)) runs += line.run + "; ";
        return runs;
    };
    const std::string sizes = "SPH at 0.0565685 m; SPH at 0.04 m; SPH at 0.0282843 m; SPH at 0.02 m; ";
    EXPECT_EQ(plan({}), sizes + "SPH at 0.0475683 m, between two sizes; SPH at 0.0336359 m, between two sizes; ");
    EXPECT_EQ(plan({"--no-fill"}), sizes);
    EXPECT_EQ(plan({"--levels", "3"}), "SPH at 0.04 m; SPH at 0.0282843 m; SPH at 0.02 m; ");
}

TEST_F(Command, ABudgetLeavesOutTheFilledInSizesBeforeAnyOther) {
    write("column.toml", column);
    const std::vector<PlannedLine> all = lines_of(twinwake({"ladder", "column.toml", "--no-variations", "--plan"}).out);
    ASSERT_EQ(all.size(), 6u);
    const double budget = (std::stod(all[3].together) + std::stod(all[4].together)) / 2;
    const std::vector<PlannedLine> tight = lines_of(
        twinwake({"ladder", "column.toml", "--no-variations", "--plan", "--budget", fmt::format("{} s", budget)}).out);
    ASSERT_EQ(tight.size(), 6u);
    for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(tight[k].state, k < 4 ? "" : "beyond the budget") << tight[k].run;
}

TEST_F(Command, TheFilledInSizesAreOfTheFamilyAndTakenWhenTheyAreThere) {
    write("column.toml", column);
    const std::vector<std::string> command{"ladder", "column.toml", "--no-variations", "--json", "facts.json"};
    const Outcome first = twinwake(command);
    ASSERT_EQ(first.status, 0) << first.err;
    const auto side = nlohmann::json::parse(content(folder_ / "facts.json"))["sides"][0];
    ASSERT_EQ(side["runs"].size(), 6u);
    EXPECT_NEAR(double(side["runs"][2]["spacing"]), 0.0336359, 1e-7);
    EXPECT_NE(side["similar"], false);
    const Outcome again = twinwake({"ladder", "column.toml", "--no-variations", "--plan"});
    for (const PlannedLine& line : lines_of(again.out)) EXPECT_EQ(line.state, "finished before") << line.run;
}

}  // namespace grid_study_fill_test
}  // namespace tw::test

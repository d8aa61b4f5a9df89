// The run in a wider box is made by the cheaper method, and which one that is does not change while a study runs.
#include <nlohmann/json.hpp>
#include <sstream>

#include "program.h"
#include "record/this_machine.h"

namespace tw::test {
namespace grid_study_box_test {

/// The plan's row that holds `part`.
std::string row_of(const std::string& plan, const std::string& part) {
    std::istringstream text(plan);
    for (std::string line; std::getline(text, line);)
        if (line.find(part) != std::string::npos) return line;
    return {};
}

TEST_F(Command, TheMethodOfTheWiderBoxDoesNotFollowWhatRunsTeach) {
    write("open.toml", planing);
    std::string boxes[2], times[2];
    for (const int slow : {0, 1}) {
        const nlohmann::json paces{{cpu_model(), {{"sph", {slow == 0 ? 50 : 0.02}}, {"fvm", {slow == 1 ? 50 : 0.02}}}}};
        write("cache/twinwake/pace.json", paces.dump());
        const Outcome plan = twinwake({"ladder", "open.toml", "--method", "both", "--levels", "2", "--plan"});
        ASSERT_EQ(plan.status, 0) << plan.err;
        const std::string row = row_of(plan.out, "box x 1.5");
        boxes[slow] = row.substr(0, row.find(" m, box"));
        times[slow] = row;
    }
    EXPECT_FALSE(boxes[0].empty());
    EXPECT_EQ(boxes[0], boxes[1]);
    EXPECT_NE(times[0], times[1]) << "the paces were not read: this test sees nothing";
}

}  // namespace grid_study_box_test
}  // namespace tw::test

// tools/savitsky.sh, the empirical neighbour of the planing studies, against an independently computed table.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace {

struct Answer {
    int status = -1;
    std::string text;
};

Answer savitsky(const std::string& arguments) {
    const std::string command = "'" TWINWAKE_SOURCE "/tools/savitsky.sh' " + arguments + " 2>&1";
    FILE* pipe = popen(command.c_str(), "r");
    Answer answer;
    std::array<char, 512> part{};
    while (fgets(part.data(), part.size(), pipe)) answer.text += part.data();
    answer.status = pclose(pipe);
    return answer;
}

// Columns: Cv, deadrise [deg], trim [deg], lambda, beam [m], U [m/s], CL0, CLbeta, lift [N], Cf, friction, drag [N], ...
std::vector<std::vector<double>> table() {
    std::ifstream file(TWINWAKE_TEST_DATA "/savitsky_prismatic_fixed_trim.csv");
    std::vector<std::vector<double>> rows;
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
        std::istringstream cells(line);
        std::vector<double> row;
        for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
        rows.push_back(row);
    }
    return rows;
}

TEST(Savitsky, LiftAndDragEqualTheIndependentTable) {
    const auto rows = table();
    ASSERT_GE(rows.size(), 90u);
    for (const auto& row : rows) {
        std::ostringstream arguments;
        arguments.precision(10);
        // The table's water: standard gravity, fresh water of 15 degrees.
        arguments << "deadrise=" << row[1] << " trim=" << row[2] << " lambda=" << row[3] << " beam=" << row[4]
                  << " speed=" << row[5] << " gravity=9.80665 viscosity=1.139e-6";
        const Answer answer = savitsky(arguments.str());
        ASSERT_EQ(answer.status, 0) << answer.text;
        const auto result = nlohmann::json::parse(answer.text);
        EXPECT_NEAR(result["lift"].get<double>() / row[8], 1, 2e-6) << arguments.str();
        EXPECT_NEAR(result["drag"].get<double>() / row[11], 1, 2e-6) << arguments.str();
    }
}

TEST(Savitsky, KeelDraftGivesTheWettedKeel) {
    // A keel 0.2 m deep at the transom, at 5 degrees, is wet over 0.2 / sin 5 deg = 2.2947 m.
    const Answer answer = savitsky("beam=1 speed=8 deadrise=20 trim=5 draft=0.2");
    ASSERT_EQ(answer.status, 0) << answer.text;
    EXPECT_NEAR(nlohmann::json::parse(answer.text)["keel_wetted_length"].get<double>(), 2.29474, 1e-5);
}

TEST(Savitsky, RefusesWhatItDoesNotKnow) {
    for (const std::string arguments :
         {"", "beam=1 speed=8 deadrise=20 trim=5", "beam=1 speed=8 deadrise=20 trim=-5 draft=0.2", "hull=1",
          "beam=1;id speed=8", "'beam=1\"); system(\"id' speed=8"}) {
        const Answer answer = savitsky(arguments);
        EXPECT_NE(answer.status, 0) << arguments;
        EXPECT_EQ(answer.text.find("uid="), std::string::npos) << arguments;
    }
}

}  // namespace

// Walls from which water lets go, through the real interFoam and the library of foam_cases/ventilated_wall.
#include <algorithm>
#include <cmath>

#include "foam_test.h"

namespace tw {
namespace ventilated_walls_test {

class VentilatedWalls : public FoamTest {
protected:
    void SetUp() override {
        FoamTest::SetUp();
        if (IsSkipped()) return;
        if (sound_openfoam().wall_library.empty())
            GTEST_SKIP() << "no library of walls: twinwake setup-openfoam builds it";
    }
    RunRecord run(const std::string& text, bool let_go) {
        const Scene s = scene(text + "[effects]\nventilation = \"" + (let_go ? "on" : "off") + "\"\n");
        RunOptions o = options();
        o.folder /= let_go ? "let_go" : "held";
        return run_fvm(s, o);
    }
};

/// The row of `column` at `time`, between its neighbours.
double at(const Table& t, const char* column, double time) {
    const auto next = static_cast<std::size_t>(std::lower_bound(t.time.begin(), t.time.end(), time) - t.time.begin());
    const std::vector<double>& v = t.find(column)->values;
    return std::lerp(v[next - 1], v[next], (time - t.time[next - 1]) / (t.time[next] - t.time[next - 1]));
}

// A cylinder of the water's density, 0.11 m, enters at 2.955 m/s. By boundary elements of our own, whose water leaves
// the cylinder at 60 degrees from the nose, it is 0.105 m deep after 0.05 s and 0.187 m after 0.1 s (good to 2 %;
// leaving at 70 degrees changes them by less than 3 %).
TEST_F(VentilatedWalls, ACylinderEntersAsDeepAsPotentialFlowWithAFreeSheetHasIt) {
    const std::string entry = body_in_tank(R"(["-0.7 m", 0, "-0.5 m"])", R"(["0.7 m", "20 mm", "0.3 m"])", R"(
name = "cylinder"
shape = "cylinder"
diameter = "110 mm"
draft = 0
density = "1000 kg/m3"
velocity = [0, 0, "-2.955 m/s"]
locked = ["surge", "pitch"])",
                                           "0.102 s") +
                              "[sampling]\ninterval = \"10 ms\"\n";
    const auto depth = [](const RunRecord& r, double time) {
        return -at(r.tables.at("body_cylinder"), "lowest", time);
    };
    const auto pull = [](const RunRecord& r) {
        const auto& force = r.tables.at("samples").find("suction_force_cylinder")->values;
        return *std::max_element(force.begin(), force.end());
    };
    const RunRecord free = run(entry, true), held = run(entry, false);
    ASSERT_EQ(free.state, "finished") << free.reason;
    ASSERT_EQ(held.state, "finished") << held.reason;
    EXPECT_EQ(free.attributes.at("walls"), "allow separation at ambient pressure where air can reach them");
    EXPECT_NEAR(depth(free, 0.05) / 0.105, 1, 0.04);
    EXPECT_NEAR(depth(free, 0.1) / 0.187, 1, 0.04);
    EXPECT_GT(depth(held, 0.1) / 0.187, 1.06) << "water that is held turns round the cylinder and pulls it down";
    EXPECT_GT(pull(held), 50) << "of 222 N/m that the water presses with";
    EXPECT_LT(pull(free), 0.2 * pull(held));
}

// Far from the air nothing changes, not by a bit.
TEST_F(VentilatedWalls, DeepUnderWaterHoldItsSuction) {
    const std::string deep = body_in_tank(R"(["-0.6 m", 0, "-0.6 m"])", R"(["0.6 m", "20 mm", "0.2 m"])", R"(
name = "box"
shape = "box"
length = "0.2 m"
height = "0.1 m"
draft = "0.3 m"
motion = "prescribed"
law = "constant"
along = [1, 0, 0]
rate = "4 m/s")",
                                          "8 ms") +
                             "[sampling]\ninterval = \"2 ms\"\n";
    const RunRecord free = run(deep, true), held = run(deep, false);
    ASSERT_EQ(free.state, "finished") << free.reason;
    const auto& pull = free.tables.at("samples").find("suction_force_box")->values;
    EXPECT_GT(*std::max_element(pull.begin(), pull.end()), 10) << "or this test sees nothing";
    for (const char* column : {"fx", "fz"}) {
        const auto forces = [&](const RunRecord& r) {
            const auto& rows = r.tables.at("body_box").find(column)->values;
            return std::vector<double>(rows.begin() + 3, rows.end());  // the first three are the start's, left empty
        };
        EXPECT_EQ(forces(free), forces(held)) << column;
        EXPECT_GT(forces(free).size(), 10u);
    }
}

}  // namespace ventilated_walls_test
}  // namespace tw

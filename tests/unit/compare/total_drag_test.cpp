// Drag and friction together.
#include <gtest/gtest.h>

#include "compare/compare.h"
#include "compare/verdict/quantity_kinds.h"
#include "synthetic_pair.h"

namespace tw {
namespace total_drag_test {

/// A planing prism, of whose friction its method knows the line.
RunRecord with_line(const char* method, double friction) {
    RunRecord r = synthetic_run({.method = method, .duration = 6, .step = 4e-3});
    const std::vector<double> time = r.tables.at("forces").time;
    Table& samples = r.table("samples");
    samples.columns.clear();
    samples.time = time;
    samples.column("friction_line", "N").values.assign(time.size(), friction);
    samples.column("wetted_area", "m2").values.assign(time.size(), 2.5);
    return r;
}

TEST(TotalDrag, IsDragAndTheLineOfEachMethod) {
    const Comparison c = compare_records({with_line("sph", 200), with_line("fvm", 240)});
    const Quantity *total = c.find("total_drag"), *drag = c.find("drag"), *line = c.find("friction_line");
    ASSERT_TRUE(total && drag && line);
    EXPECT_NEAR(total->values[0].value, drag->values[0].value + 200, 1e-9);
    EXPECT_NEAR(total->values[1].value, drag->values[1].value + 240, 1e-9);
    EXPECT_TRUE(total->judged);
    EXPECT_FALSE(line->judged);
    // 200 N over 1000 kg/m3 (8 m/s)^2 / 2 2.5 m2
    EXPECT_NE(total->remark.find("C_F 0.0025"), std::string::npos) << total->remark;
}

// A friction that rises steadily by 6 % of itself leaves less than the 1.5 flow-through times that a mean needs, once
// its start is cut off; of the drag of 250 N it is 0.7 %.
TEST(TotalDrag, IsKnownWhereFrictionCreepsByLittleOfTheDrag) {
    RunRecord r = with_line("sph", 30);
    r.numbers["length"] = 20;  // 1.5 times over are 3.75 of 5.5 s
    Table& samples = r.tables.at("samples");
    for (std::size_t k = 0; k < samples.time.size(); ++k)
        samples.column("friction_line", "N").values[k] += 1.9 * samples.time[k] / samples.time.back();
    const Comparison c = compare_records({r});
    const Quantity *total = c.find("total_drag"), *drag = c.find("drag");
    ASSERT_TRUE(drag && drag->values[0].known);
    ASSERT_TRUE(total && total->values[0].known);
    EXPECT_NEAR(total->values[0].value, drag->values[0].value + 31.35, 0.05);  // in the middle of 4 to 9.5 s
    EXPECT_GT(total->values[0].half_width, 1.7) << "what it may still change by";
}

TEST(TotalDrag, HasAnEffectivePowerAndACoefficientAndComesFirst) {
    const Comparison c = compare_records({with_line("sph", 200), with_line("fvm", 240)});
    const Quantity *total = c.find("total_drag"), *power = c.find("effective_power"),
                   *coefficient = c.find("resistance_coefficient");
    ASSERT_TRUE(total && power && coefficient);
    for (std::size_t s = 0; s < 2; ++s) {
        EXPECT_NEAR(power->values[s].value, total->values[s].value * 8, 1e-6);
        EXPECT_NEAR(coefficient->values[s].value, total->values[s].value / (0.5 * 1000 * 64 * 2.5), 1e-9);
        EXPECT_NEAR(coefficient->values[s].half_width / coefficient->values[s].value,
                    total->values[s].half_width / total->values[s].value, 1e-9);
    }
    EXPECT_FALSE(power->judged || coefficient->judged) << "the drag is";
    EXPECT_EQ(main_quantities(c.quantities).front()->name, "total_drag");
    EXPECT_EQ(c.find("drag")->label, "Pressure drag");
    EXPECT_EQ(compare_records({synthetic_run({.method = "sph"})}).find("effective_power"), nullptr)
        << "pressure alone is no resistance";
}

TEST(TotalDrag, OfAMethodThatSolvesFrictionHasNoLineOnTop) {
    RunRecord solves = with_line("fvm", 240);
    Table& forces = solves.tables.at("forces");
    forces.column("fx_viscous", "N").values.assign(forces.time.size(), 210);
    forces.column("fx_pressure", "N").values = forces.column("fx", "N").values;
    for (double& x : forces.column("fx_pressure", "N").values) x -= 210;
    const Comparison c = compare_records({with_line("sph", 200), solves});
    EXPECT_NEAR(c.find("total_drag")->values[1].value - c.find("drag")->values[1].value, 210, 1e-6);
}

TEST(TotalDrag, IsNotThereWithoutALine) {
    EXPECT_EQ(compare_records({synthetic_run({.method = "sph"})}).find("total_drag"), nullptr);
}

}  // namespace total_drag_test
}  // namespace tw

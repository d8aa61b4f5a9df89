#include "spray/report/two_sprays.h"

#include <gtest/gtest.h>

#include <vector>

namespace tw::spray {
namespace two_sprays_test {

std::vector<Droplet> spray(int count, double diameter, const Vec3& velocity) {
    std::vector<Droplet> all;
    for (int i = 0; i < count; ++i) all.push_back({Vec3::Zero(), velocity, diameter * (1 + 0.01 * i), 0});
    return all;
}
double value(const ReportTable& t, const std::string& name, std::size_t column) {
    for (const ReportRow& row : t.rows)
        if (row.cells.at(0).text == name) return row.cells.at(column).number;
    throw std::logic_error("no row " + name);
}

TEST(TwoSprays, DifferByTheirStatistics) {
    const auto one = spray(100, 1e-3, {0, 3, 3}), other = spray(200, 2e-3, {0, 0, 6});
    const ReportTable t = two_sprays({"one", one}, {"other", other}, {});
    EXPECT_EQ(value(t, "number", 2), 100);
    EXPECT_EQ(value(t, "number", 3), 200);
    EXPECT_NEAR(value(t, "mean diameter", 2), 1.495, 1e-9);
    double volume = 0, area = 0;
    for (const Droplet& d : one) volume += sphere_volume(d.diameter), area += d.diameter * d.diameter;
    EXPECT_NEAR(value(t, "volume", 2), 1e6 * volume, 1e-12);
    EXPECT_NEAR(value(t, "Sauter's diameter, volume over area", 2), 1e3 * volume / area / sphere_volume(1), 1e-9);
    EXPECT_GT(value(t, "diameter with half of the volume below it", 2), 1.495);
    EXPECT_NEAR(value(t, "rise of the water over level", 2), 45, 1e-9);
    EXPECT_NEAR(value(t, "rise of the water over level", 3), 90, 1e-9);
    EXPECT_NEAR(value(t, "momentum z", 2), 3 * 1000 * volume, 1e-12);
    EXPECT_NEAR(value(t, "kinetic energy", 2), 9 * 1000 * volume, 1e-12);
    EXPECT_NE(t.notes.at(0).find("1.000 of speeds"), std::string::npos) << t.notes.at(0);
}

TEST(TwoSprays, OfWhichOneIsEmptyAreNotCompared) {
    const auto one = spray(3, 1e-3, {1, 0, 0});
    const ReportTable t = two_sprays({"one", one}, {"none", {}}, {});
    EXPECT_EQ(t.rows.size(), 2u);
    EXPECT_NE(t.notes.at(0).find("no droplets"), std::string::npos);
}

TEST(TwoSprays, SharesDifferAsCounted) {
    const std::vector<double> a{1, 2, 3, 4}, b{3, 4, 5, 6};
    EXPECT_EQ(largest_share_difference(a, a), 0);
    EXPECT_EQ(largest_share_difference(a, b), 0.5);
    EXPECT_EQ(largest_share_difference(b, a), 0.5);
    EXPECT_EQ(largest_share_difference(std::vector<double>{1.00000001}, std::vector<double>{1}), 0);
    EXPECT_EQ(largest_share_difference(std::vector<double>{1, 1}, std::vector<double>{2}), 1);
    EXPECT_EQ(largest_share_difference(std::vector<double>{10}, std::vector<double>{1, 2, 3}), 1);
}

}  // namespace two_sprays_test
}  // namespace tw::spray

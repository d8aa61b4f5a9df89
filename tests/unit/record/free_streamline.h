#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "test_paths.h"

namespace tw {

/// tests/data/free_jet_cylinder_streamline.csv: how far the water is from a cylinder in a free jet.
struct FreeStreamlines {
    struct Line {
        std::vector<std::pair<double, double>> points;  ///< angle from the nose [degrees], gap over the radius
        double leaves() const { return points.front().first; }
        /// Gap over the radius at an angle from the nose [degrees]; 1, which is far, beyond the table.
        double gap(double angle) const {
            if (angle <= leaves()) return 0;
            if (angle >= points.back().first) return 1;
            const auto after = std::ranges::upper_bound(points, angle, {}, &std::pair<double, double>::first);
            const auto& [a0, g0] = *(after - 1);
            return g0 + (after->second - g0) * (angle - a0) / (after->first - a0);
        }
    };
    std::map<double, Line> lines;  ///< by the cylinder's radius over half of the jet's width

    FreeStreamlines() {
        std::ifstream in(TWINWAKE_TEST_DATA "/free_jet_cylinder_streamline.csv");
        std::string head;
        std::getline(in, head);
        double breadth = 0, angle = 0, gap = 0;
        for (char comma; in >> breadth >> comma >> angle >> comma >> gap;)
            lines[breadth].points.emplace_back(angle, gap);
        EXPECT_EQ(lines.size(), 2u);
    }
};

}  // namespace tw

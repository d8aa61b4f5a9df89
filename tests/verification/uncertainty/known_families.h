#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "compare/uncertainty/study_level.h"

namespace tw::test {

/// A refinement study whose value at zero spacing is known.
struct KnownFamily {
    std::string name;   ///< of an exact case
    std::string trend;  ///< of a manufactured family
    double noise = 0;   ///< standard deviation at h_1 over the trend's error at h_1 [-]
    std::vector<StudyLevel> levels;
    double truth = 0;
};

/// phi_i = 1 + 0.02 f(x_i) + e_i, x_i = h_i/h_1: an error of 2 % at the finest size. For each of
/// - seven trends f: x, x^1.5, x^2, (x + x^2)/2, 2x - x^2/4 (turns round at the coarsest sizes), (-1)^i x, none;
/// - standard deviations of e_i of 0, 0.1, 0.3, 1 and 3 times 0.02 (none: without 0), the same at every size or growing
///   with h;
/// - sizes: 3, 4, 5, 6 and 8 (ratios of sqrt 2; of 1.2 to 1.25 from five on; the eight of the planing prism);
/// `repetitions` draws. The same seed gives the same families.
std::vector<KnownFamily> manufactured_families(int repetitions, unsigned seed);
/// The same of other sizes, over the one whose error is 2 %, finest first. `known`: each level has the half width of its
/// noise, as a time mean has.
std::vector<KnownFamily> manufactured_families(int repetitions, unsigned seed,
                                               const std::vector<std::vector<double>>& sizes, bool known = false);

/// The cases with an exact answer of docs/results, from tests/data/exact_families.csv (values in per cent of the exact
/// one). Two sizes or more.
std::vector<KnownFamily> exact_families(const std::filesystem::path& csv);

}  // namespace tw::test

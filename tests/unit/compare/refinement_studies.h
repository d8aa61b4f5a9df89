#pragma once
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "base/errors.h"
#include "compare/uncertainty/study_level.h"

// Refinement studies that the tests of the uncertainty share.

namespace tw {
namespace uncertainty_test {

inline const std::vector<double> five{1, 1.25, 1.5, 2, 2.5};

inline std::vector<StudyLevel> study(const std::vector<double>& h, const std::vector<double>& phi) {
    std::vector<StudyLevel> levels;
    for (std::size_t i = 0; i < h.size(); ++i) levels.push_back({h[i], phi[i]});
    return levels;
}
/// phi = phi0 + a h^p
inline std::vector<StudyLevel> power(const std::vector<double>& h, double phi0, double a, double p) {
    std::vector<StudyLevel> levels;
    for (const double x : h) levels.push_back({x, phi0 + a * std::pow(x, p)});
    return levels;
}
/// From numbers of cells of a plane mesh: h = N^(-1/2).
inline std::vector<StudyLevel> plane_meshes(const std::vector<double>& N, const std::vector<double>& phi) {
    std::vector<double> h;
    for (const double n : N) h.push_back(1 / std::sqrt(n));
    return study(h, phi);
}
inline const std::vector<StudyLevel> celik_monotone = plane_meshes({18000, 8000, 4500}, {6.063, 5.972, 5.863});
inline const std::vector<StudyLevel> noisy = study(five, {1.0511, 1.0688, 1.0926, 1.1409, 1.1981});

inline std::string message(const std::function<void()>& call) {
    try {
        call();
    } catch (const InputError& e) { return e.what(); }
    return {};
}

}  // namespace uncertainty_test
}  // namespace tw

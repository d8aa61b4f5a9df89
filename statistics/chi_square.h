#pragma once
#include <cmath>

namespace tw {

/// Quantile of chi-square with `degrees` of freedom at z standard deviations of a normal variable [-], -1.96: of 2.5 %,
/// 1.96: of 97.5 %; within 0.3 % from 10 degrees on (Wilson & Hilferty, PNAS 17 (1931) 684).
inline double chi_square(double degrees, double z) {
    const double part = 2 / (9 * degrees), root = 1 - part + z * std::sqrt(part);
    return degrees * root * root * root;
}

}  // namespace tw

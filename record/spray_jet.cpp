#include "record/spray_jet.h"

#include <fmt/format.h>

#include <cmath>

namespace tw {

std::string SprayJet::why_not_resolved() const {
    if (resolved()) return {};
    const double enough = thickness / 3, digit = std::pow(10, std::floor(std::log10(enough)) - 1);
    return fmt::format(
        "not resolved: the jet is {:.2g} of a particle or cell thick, and three across it are needed (near_hull = "
        "{:g} mm)",
        across(), 1e3 * digit * std::floor(enough / digit));
}

}  // namespace tw

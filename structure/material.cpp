#include "structure/material.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace tw::structure {

PlyMaterial isotropic(double E, double nu, double density) {
    const double G = E / (2 * (1 + nu));
    return {E, E, nu, G, G, G, density};
}

std::string impossible(const PlyMaterial& m) {
    const std::pair<const char*, double> positive[] = {{"E1", m.E1},   {"E2", m.E2},   {"G12", m.G12},
                                                       {"G13", m.G13}, {"G23", m.G23}, {"density", m.density}};
    for (const auto& [name, value] : positive)
        if (!(std::isfinite(value) && value > 0))
            return fmt::format("{} = {}; expected a positive number", name, value);
    if (!(m.nu12 * m.nu12 < m.E1 / m.E2))
        return fmt::format("nu12 = {}; expected less than sqrt(E1 / E2) = {:.4g} in size", m.nu12,
                           std::sqrt(m.E1 / m.E2));
    const double nu = m.E1 / (2 * m.G12) - 1;
    const bool is_isotropic = m.E1 == m.E2 && std::abs(nu - m.nu12) < 1e-9;
    if (is_isotropic && !(nu > -1 && nu < 0.5))
        return fmt::format("Poisson's ratio {:.4g}; expected -1 < nu < 0.5", nu);
    return {};
}

}  // namespace tw::structure

#pragma once
#include <optional>

#include "record/run_record.h"

namespace tw {

/// Drag that the resolution makes on a closed body wholly under water, where potential flow has none (d'Alembert):
///
///   D_num = C 1/2 rho U^2 A,   C = 1.65 dp / d
///
/// A: frontal area, d: the hull's smaller extent across the stream, dp: spacing at the hull. First order: the artificial
/// viscosity or the cells' diffusion lets the flow leave the tail. Measured on an ellipse (C = 0.28 and 0.14 at d/dp = 6
/// and 12, docs/results/ellipse_in_a_stream.md); a size, good to a factor of two.
struct NumericalDrag {
    double force = 0;        ///< D_num [N]
    double coefficient = 0;  ///< C [-]
    double spacings = 0;     ///< d / dp [-]
};
/// Nothing for a hull that reaches up to still water, or where the record lacks a number.
std::optional<NumericalDrag> numerical_drag(const RunRecord& record);

}  // namespace tw

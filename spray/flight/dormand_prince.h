#pragma once
#include <array>

#include "base/vec3.h"

namespace tw::spray {

/// Place and velocity, or their rates.
using State6 = Eigen::Matrix<double, 6, 1>;

/// One step of Dormand & Prince's embedded pair 5(4) with its continuous output of order 4 (Hairer, Norsett & Wanner,
/// Solving Ordinary Differential Equations I, section II.6).
struct DormandPrinceStep {
    State6 y0, y1;  ///< before and after
    double h = 0;   ///< [s]
    std::array<State6, 7> k;
    State6 error;  ///< of the lower order

    /// `rate(y)` gives dy/dt or throws; k[0] must hold rate(y0).
    template <class Rate>
    void take(double step, Rate rate) {
        h = step;
        k[1] = rate(y0 + h * (1.0 / 5 * k[0]));
        k[2] = rate(y0 + h * (3.0 / 40 * k[0] + 9.0 / 40 * k[1]));
        k[3] = rate(y0 + h * (44.0 / 45 * k[0] - 56.0 / 15 * k[1] + 32.0 / 9 * k[2]));
        k[4] =
            rate(y0 + h * (19372.0 / 6561 * k[0] - 25360.0 / 2187 * k[1] + 64448.0 / 6561 * k[2] - 212.0 / 729 * k[3]));
        k[5] = rate(y0 + h * (9017.0 / 3168 * k[0] - 355.0 / 33 * k[1] + 46732.0 / 5247 * k[2] + 49.0 / 176 * k[3] -
                              5103.0 / 18656 * k[4]));
        y1 = y0 + h * (35.0 / 384 * k[0] + 500.0 / 1113 * k[2] + 125.0 / 192 * k[3] - 2187.0 / 6784 * k[4] +
                       11.0 / 84 * k[5]);
        k[6] = rate(y1);
        error = h * (71.0 / 57600 * k[0] - 71.0 / 16695 * k[2] + 71.0 / 1920 * k[3] - 17253.0 / 339200 * k[4] +
                     22.0 / 525 * k[5] - 1.0 / 40 * k[6]);
    }

    /// The state at the share s of the step, 0 to 1.
    State6 at(double s) const {
        const State6 difference = y1 - y0, bend = h * k[0] - difference;
        const State6 last = difference - h * k[6] - bend;
        const State6 d = h * (-12715105075.0 / 11282082432.0 * k[0] + 87487479700.0 / 32700410799.0 * k[2] -
                              10690763975.0 / 1880347072.0 * k[3] + 701980252875.0 / 199316789632.0 * k[4] -
                              1453857185.0 / 822651844.0 * k[5] + 69997945.0 / 29380423.0 * k[6]);
        return y0 + s * (difference + (1 - s) * (bend + s * (last + (1 - s) * d)));
    }
};

}  // namespace tw::spray

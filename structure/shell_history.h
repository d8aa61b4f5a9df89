#pragma once
#include <vector>

#include "structure/degrees_of_freedom.h"
#include "structure/shell/gauge.h"
#include "structure/shell/shell.h"

namespace tw::structure {

/// A pressure on each element of a shell over time, on the face out of which its normal points: linear between the
/// times, and beyond them that of the first and the last.
struct PressureHistory {
    std::vector<double> time;               ///< [s], rising
    std::vector<Eigen::VectorXd> pressure;  ///< for each time one value per element [Pa]
    Eigen::VectorXd at(double t) const;
    double longest_gap() const;  ///< between two times [s]
};

/// What a shell undergoes besides the pressure, and how it is stepped.
struct ShellConditions {
    Vec3 velocity = Vec3::Zero();  ///< of all of it at the first time, unstrained [m/s]
    Vec3 gravity = Vec3::Zero();   ///< [m/s2]
    double damping = 0;            ///< f = -damping M v [1/s]
    bool large_rotations = true;
    double step = 0;  ///< of the average acceleration method [s]
};

/// How a shell moves, at the end of each step; the start first.
struct ShellHistory {
    std::vector<double> time;                      ///< [s]
    std::vector<std::vector<double>> strains;      ///< of each gauge, one for each time [-]
    std::vector<std::vector<Vec3>> displacements;  ///< of each point, one for each time [m]
};

/// The shell under a pressure that does not feel how it moves, from the history's first time to its last, along the
/// normals of the reference state. A step that does not balance at large rotations makes all of them half as long, 64
/// times as short at most. Throws InputError for a history without times or of another number of elements, for a step
/// that is not positive and for a gauge that is not on the shell; RunError where the shortest steps do not balance.
ShellHistory shell_history(const Shell& shell, const DegreesOfFreedom& dofs, const PressureHistory& pressure,
                           const std::vector<Gauge>& gauges, const std::vector<Vec3>& points,
                           const ShellConditions& conditions);

}  // namespace tw::structure

#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/vec3.h"

namespace tw {

/// What interFoam's log says, fed in pieces as it grows. One entry per time step; a restart in the same log replaces
/// all entries beyond the time it starts from.
class SolverLog {
public:
    /// A free body as the last outer corrector left it.
    struct Body {
        std::string name;  ///< as the case has it; empty where it moves one body alone
        Vec3 centre = Vec3::Zero(), velocity = Vec3::Zero(), spin = Vec3::Zero();  ///< of mass [m], [m/s], [rad/s]
        Eigen::Matrix3d attitude = Eigen::Matrix3d::Identity();                    ///< body to earth
    };
    struct Step {
        double time = 0, step = 0;              ///< [s]
        double courant = 0, alpha_courant = 0;  ///< largest, anywhere and at the surface [-]
        double water = 0;                       ///< volume fraction of the domain [-]; NaN before the first solution
        double least = 0, most = 0;             ///< water fraction of any cell [-]
        double continuity = 0;                  ///< error of it after the last corrector, in volumes of the domain [-]
        double cpu = 0;                         ///< ExecutionTime since this start of the solver [s]
        std::vector<Body> bodies;               ///< of several, as the step left them; empty with one
    };
    void feed(std::string_view text);

    const std::vector<Step>& steps() const { return steps_; }
    const std::vector<Body>& bodies() const { return bodies_; }
    bool ended() const { return ended_; }                ///< "End" was reached
    const std::string& fatal() const { return fatal_; }  ///< OpenFOAM's own error message; empty: none
    /// The step that was current at `time`: the last one not later; nullptr before the first.
    const Step* at(double time) const;
    /// Last lines [at most `lines`].
    std::string tail(std::size_t lines) const;

private:
    void line(std::string_view text);
    void body_line(std::string_view text);
    void turn_to(std::string_view body);
    std::string partial_;
    std::vector<std::string> recent_;
    std::vector<Step> steps_;
    Step next_;
    std::vector<Body> bodies_;
    std::size_t body_ = 0;  ///< whose lines come
    bool ended_ = false;
    int fatal_lines_ = 0;
    std::string fatal_;
};

}  // namespace tw

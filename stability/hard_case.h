#pragma once
#include <functional>
#include <string>
#include <vector>

#include "record/run_record.h"

namespace tw {

/// The small two-dimensional runs of the stability map; each strains another part of the particle simulation.
///
///   impact  a block of water thrown up at a fixed hull section with hard chines, 1 m wide: the blow, the jets, the
///           sharp edges, the cavity above the chines; gravity is on
///   stream  a flat plate, 1 m long, planes at a trim of `deadrise` on a stream between inlet and outlet: what has to
///           leave leaves
///   tank    water at rest, 1 m deep and 3 m long, for 40 sqrt(depth / g) = 12.8 s: nothing may move at the end
enum class HardCaseKind { impact, stream, tank };
const char* to_string(HardCaseKind kind);

struct HardCase {
    HardCaseKind kind = HardCaseKind::impact;
    double speed = 30;           ///< of the water against the section or the plate [m/s]; not used in the tank
    double deadrise_deg = 30;    ///< of the section; the trim of the plate; not used in the tank [deg]
    double h_over_dp = 1.5;      ///< smoothing length over spacing [-]
    double cfl = 0.7;            ///< acoustic Courant number [-]
    double c0_over_speed = 20;   ///< sound speed over `speed`; in the tank over sqrt(2 g depth) [-]
    double spacings_per_m = 40;  ///< 1 / dp, of the finest particles [1/m]
    /// Particles of dp within so many dp of section or plate, or of the tank's middle, and of 2 dp elsewhere; 0: of one
    /// size. At least 8.
    double zone = 0;
    bool operator==(const HardCase&) const = default;

    double reference_speed() const;  ///< what c0 is a multiple of [m/s]
    double duration() const;         ///< simulated [s]
    double predicted_work() const;   ///< particles times steps, roughly: for the time left
};

/// The outcome of one case.
struct HardCaseRun {
    /// The run's validity checks (`watch_stability`) and, beside it, what these cases alone can tell:
    ///   particles missing      start + in - out - now, and in closed cases what went out          0
    ///   energy made            impact: largest growth over the kinetic energy at the start; tank: over the potential energy
    ///   motion of still water  tank: kinetic energy at the end over rho g H V
    ///   pressure error         tank: root mean square of (p - rho g depth) at the end, over rho g H
    std::vector<RecordedCheck> lines;
    std::string failure;   ///< what the engine said when it stopped; empty: it came to the end
    bool stopped = false;  ///< at the caller's wish, before the end
    double time = 0, steps = 0, particles = 0, seconds = 0;
};

/// Runs the case on the calling thread alone. `go_on` is asked now and then with the time reached [s]; once it says no,
/// the run ends there. What the engine throws is a result, not an error.
HardCaseRun run_hard_case(const HardCase& c, const std::function<bool(double)>& go_on = {});

}  // namespace tw

#include "stability/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sph_solver/simulation.h"

namespace tw {

namespace {

constexpr const char* slow_sound = "c0 too low";

std::string percent(double value) {
    return value < 100 ? fmt::format("{:.2g} %", value) : fmt::format("{:.0f} %", value);
}

/// A value with its unit in the few letters of a map's cell.
std::string label_of(const std::string& line, double value) {
    if (line == "Mach number") return fmt::format("Ma {:.2g}", value);
    if (line == "compression") return "rho +" + percent(value);
    if (line == "rarefaction") return "rho -" + percent(value);
    if (line == "energy made") return "E +" + percent(value);
    if (line == "motion of still water") return fmt::format("KE {:.0e}", value);
    if (line == "pressure error") return "p " + percent(value);
    if (line == "step held down") return fmt::format("dt / {:.2g}", value);
    return fmt::format("{:g} gone", value);
}

}  // namespace

const char* to_string(Stability stability) {
    static constexpr const char* names[] = {"stable", "warned", "failed"};
    return names[static_cast<int>(stability)];
}

const std::vector<StabilityLimit>& stability_limits() {
    constexpr double density = 100 * largest_density_deviation;
    static const std::vector<StabilityLimit> limits = {
        {"particles lost", "-", 0, 0, "it violates a physical law", "walls are closed"},
        {"particles missing", "-", 0, 0, "it violates a physical law", "mass is kept"},
        {"energy made", "%", 0.1, 1, "it violates a physical law",
         "nothing at rest gives energy; what is usual is below 0.01 %"},
        {"motion of still water", "-", 1e-6, 1e-4, "still water is not still",
         "kinetic energy over rho g H V after 40 sqrt(H / g): 1e-6 is asked of a still tank"},
        {"pressure error", "%", 2, 5, "still water is not still",
         "root mean square over rho g H of water that stands still"},
        {"Mach number", "-", trusted_mach, largest_mach, slow_sound,
         "c0 of ten times the flow's speed, and half as much again; the engine stops at 1"},
        {"compression", "%", 100 * trusted_compression, density, slow_sound,
         "water compressed to 95 % of its volume is not nearly incompressible; the engine stops at 30 %"},
        {"rarefaction", "%", 5, density, "water torn", "as for compression"},
        {"step held down", "-", 20, HUGE_VAL, "time step collapsed", "as in the validity checks of a run"},
    };
    return limits;
}

StabilityJudgement judge_stability(const HardCase& c, const HardCaseRun& run) {
    StabilityJudgement j;
    std::string told;  // the meaning that the reason's last words belong to
    const auto beyond = [&](Stability s, const std::string& meaning, const std::string& numbers) {
        j.stability = std::max(j.stability, s);
        j.reason += !j.reason.empty() && meaning == told
                        ? ", "
                        : (j.reason.empty() ? "" : "; ") + (meaning.empty() ? "" : meaning + ": ");
        j.reason += numbers;
        told = meaning;
    };
    if (!run.failure.empty())
        beyond(Stability::failed, "", run.failure);
    else if (!(run.steps > 0))
        beyond(Stability::failed, "", "nothing was run");
    double nearest = -1;
    for (const StabilityLimit& limit : stability_limits()) {
        const auto line = std::ranges::find(run.lines, limit.line, &RecordedCheck::name);
        if (line == run.lines.end()) continue;
        const double value = line->value;
        if (!(value <= limit.warned)) {
            std::string meaning = limit.meaning;
            if (meaning == slow_sound && c.cfl > stated_courant_limit) meaning = "time step too long or c0 too low";
            const std::string unit = limit.unit == "-" ? "" : " " + limit.unit;
            const bool warned = value <= limit.failed;
            beyond(warned ? Stability::warned : Stability::failed, meaning,
                   fmt::format("{} {:.3g}{} above {:g}{}", limit.line, value, unit,
                               warned ? limit.warned : limit.failed, unit));
        }
        double share = limit.warned > 0 ? value / limit.warned : value > 0 ? HUGE_VAL : 0;
        if (std::isnan(value)) share = HUGE_VAL;
        if (share > nearest) nearest = share, j.label = label_of(limit.line, value);
    }
    if (!run.failure.empty()) j.label = "stopped";
    return j;
}

}  // namespace tw

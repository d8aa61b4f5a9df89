#include "suite/formulas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/reference/savitsky.h"

namespace tw {
namespace {

using P = std::span<const double>;
const TruthFormula::Parameter density{"density", "kg/m3", 1000}, gravity{"gravity", "m/s2", 9.81};

Savitsky savitsky_of(P p) {
    return savitsky_at_draft(
        {.beam = p[2], .deadrise = p[3], .trim = p[4], .speed = p[6], .density = p[0], .gravity = p[1]}, p[5]);
}
const std::vector<TruthFormula::Parameter> prism{density,         gravity,        {"beam", "m"},   {"deadrise", "rad"},
                                                 {"trim", "rad"}, {"draft", "m"}, {"speed", "m/s"}};

}  // namespace

const std::vector<TruthFormula>& truth_formulas() {
    static const std::vector<TruthFormula> all{
        {"hydrostatic_pressure",
         "Pa",
         {density, gravity, {"depth", "m"}},
         [](P p) { return p[0] * p[1] * p[2]; },
         "rho g d",
         "hydrostatics"},
        {"buoyancy",
         "N",
         {density, gravity, {"volume", "m3"}},
         [](P p) { return p[0] * p[1] * p[2]; },
         "rho g V",
         "Archimedes"},
        {"stagnation_pressure",
         "Pa",
         {density, {"speed", "m/s"}},
         [](P p) { return p[0] * p[1] * p[1] / 2; },
         "rho U^2 / 2",
         "Bernoulli"},
        {"jet_force",
         "N",
         {density, {"speed", "m/s"}, {"area", "m2"}, {"turn", "rad", pi / 2}},
         [](P p) { return p[0] * p[1] * p[1] * p[2] * (1 - std::cos(p[3])); },
         "rho U^2 A (1 - cos turn)",
         "balance of momentum of a jet that is turned"},
        {"standing_wave_period",
         "s",
         {gravity, {"length", "m"}, {"depth", "m"}, {"mode", "-", 1}},
         [](P p) {
             const double k = p[3] * pi / p[1];
             return 2 * pi / std::sqrt(p[0] * k * std::tanh(k * p[2]));
         },
         "2 pi / sqrt(g k tanh k d), k = mode pi / length",
         "linear theory of waves, Lamb, Hydrodynamics, art. 228"},
        {"free_fall",
         "m",
         {gravity, {"time", "s"}},
         [](P p) { return p[0] * p[1] * p[1] / 2; },
         "g t^2 / 2",
         "Galilei"},
        {"way_in_water",
         "m",
         {gravity, {"time", "s"}, {"density_ratio", "-"}, {"added_mass", "-"}},
         [](P p) { return (p[2] - 1) / (p[2] + p[3]) * p[0] * p[1] * p[1] / 2; },
         "(s - 1) / (s + C) g t^2 / 2; down, s: body over water, C: added mass over displaced mass",
         "potential flow, Lamb, art. 68 and 92: C = 1 of a cylinder across, 1/2 of a sphere"},
        {"ritter_front",
         "m",
         {gravity, {"depth", "m"}, {"time", "s"}},
         [](P p) { return 2 * std::sqrt(p[0] * p[1]) * p[2]; },
         "2 sqrt(g H) t",
         "shallow water, Ritter 1892"},
        {"conjugate_depth",
         "m",
         {gravity, {"depth", "m"}, {"speed", "m/s"}},
         [](P p) { return p[1] / 2 * (std::sqrt(1 + 8 * p[2] * p[2] / (p[0] * p[1])) - 1); },
         "h (sqrt(1 + 8 U^2 / (g h)) - 1) / 2, behind a hydraulic jump",
         "balance of momentum, Belanger 1841"},
        {"savitsky_lift", "N", prism, [](P p) { return savitsky_of(p).lift; }, "lift of a prism, see docs/theory.md",
         "Savitsky 1964, a fit", 0.1},
        {"savitsky_drag", "N", prism, [](P p) { return savitsky_of(p).pressure_drag; },
         "its drag without friction, lift tan(trim)", "Savitsky 1964, a fit", 0.1}};
    return all;
}

const TruthFormula* find_formula(const std::string& name) {
    const auto found = std::ranges::find(truth_formulas(), name, &TruthFormula::name);
    return found == truth_formulas().end() ? nullptr : &*found;
}

std::string formulas_text() {
    std::string out;
    for (const TruthFormula& f : truth_formulas()) {
        out += fmt::format("  {} [{}] = {} ({})\n     ", f.name, f.unit, f.text, f.source);
        for (const TruthFormula::Parameter& p : f.parameters)
            out += fmt::format(" {} [{}]{}", p.name, p.unit,
                               std::isfinite(p.fallback) ? fmt::format(" ({:g})", p.fallback) : "");
        out += "\n";
    }
    return out;
}

}  // namespace tw

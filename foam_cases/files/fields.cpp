#include <algorithm>
#include <functional>

#include "foam_cases/files/case_files.h"
#include "scene/water/tailwater.h"

namespace tw {
namespace {

Value uniform(double v) { return Value::sequence({Word("uniform"), v}); }
Value uniform(const Vec3& v) { return Value::sequence({Word("uniform"), v}); }

/// A field of 0.orig: `open` gives the entries of an inlet, outlet or atmosphere, `wall` those of a tank's wall that
/// holds the water, `solid` those of a solid, if others. Plane sides are the same in every field.
std::string field(const CasePlan& plan, const char* foam_class, const char* name, const Dimensions& dimensions,
                  const Value& inside, const std::function<Dictionary(const Patch&)>& open, const Dictionary& wall,
                  const std::function<Dictionary(const Solid&)>& solid = {}) {
    Dictionary boundary;
    for (const Patch& p : plan.sides)
        boundary.add(p.name, p.plane() ? Dictionary{{"type", Word(p.mesh_type())}} : p.holds ? wall : open(p));
    for (const Solid& s : plan.solids) boundary.add(s.name, solid ? solid(s) : wall);
    add_sides_of_slab(plan, boundary);
    return foam_file(foam_class, name,
                     {{"dimensions", dimensions}, {"internalField", inside}, {"boundaryField", boundary}});
}

/// Water below z = 0 and air above, wherever the faces have moved to.
Dictionary still_water(const Flavour& flavour) {
    if (flavour.expressions())
        return {{"type", Word("exprFixedValue")}, {"valueExpr", Quoted("neg(pos().z())")}, {"value", uniform(0.0)}};
    constexpr double far = 1e5, edge = 1e-9;  // [m]
    const List heights{List{-far, 1}, List{-edge, 1}, List{0, 0}, List{far, 0}};
    return {{"type", Word("fixedProfile")},
            {"profile", Dictionary{{"type", Word("table")}, {"values", heights}}},
            {"direction", Vec3(0, 0, 1)},
            {"origin", 0},
            {"value", uniform(0.0)}};
}

}  // namespace

/// 0/alpha.water: the volume fraction of water; setFields pours it in.
std::string alpha_water(const CasePlan& plan, const std::optional<Value>& inside) {
    const auto open = [&](const Patch& p) -> Dictionary {
        if (p.open == Patch::Open::resting_water)
            return {{"type", Word("inletOutlet")}, {"inletValue", uniform(1.0)}, {"value", uniform(1.0)}};
        if (p.open == Patch::Open::water_and_air) return still_water(plan.flavour);
        const Side side = p.side;
        if (side == Side::inlet)
            return {{"type", Word(inlet_wave_type(plan, "waveInletFraction"))}, {"value", uniform(0.0)}};
        if (side == Side::outlet)  // keeps what arrives, within 0..1
            return {{"type", Word("variableHeightFlowRate")},
                    {"lowerBound", 0},
                    {"upperBound", 1},
                    {"value", uniform(0.0)}};
        return {{"type", Word("inletOutlet")},
                {"inletValue", uniform(0.0)},
                {"value", uniform(0.0)}};  // what flows in is air
    };
    const Dictionary wall{{"type", Word("zeroGradient")}};
    return field(plan, "volScalarField", "alpha.water", dimensionless, inside.value_or(uniform(0.0)), open, wall,
                 [&](const Solid&) -> Dictionary {
                     if (plan.wall_library.empty()) return wall;
                     return {{"type", Word("ventilatedWallFraction")}, {"value", uniform(0.0)}};
                 });
}

/// 0/U: water and air enter with the stream; the outlet's water keeps the mean speed of the stream, or of the water of
/// another depth behind, so that the level neither rises nor falls.
std::string velocity_field(const CasePlan& plan, const std::optional<Value>& of_cells) {
    const double speed = plan.stream ? plan.scene->motion.speed : 0;
    const Value stream = uniform(Vec3(speed, 0, 0));
    const std::optional<Tailwater> tail = tailwater(*plan.scene);
    const auto& tank = plan.scene->tank_motion;
    const Value inside = of_cells ? *of_cells : tank ? uniform(tank->velocity_of_rest()) : stream;
    const auto open = [&](const Patch& p) -> Dictionary {
        const Side side = p.side;
        if (p.open == Patch::Open::resting_water)
            return {{"type", Word("fixedValue")}, {"value", uniform(Vec3::Zero())}};
        if (p.open == Patch::Open::water_and_air)
            return {{"type", Word("pressureInletOutletVelocity")}, {"value", uniform(Vec3::Zero())}};
        if (side == Side::inlet) return {{"type", Word(inlet_wave_type(plan, "waveInletVelocity"))}, {"value", stream}};
        if (side == Side::outlet && tail && !tail->is_slow)  // no wave comes back from there: it leaves as it comes
            return {{"type", Word("inletOutlet")}, {"inletValue", uniform(Vec3::Zero())}, {"value", stream}};
        if (side == Side::outlet)  // Umean in v1912, UnMean later and at openfoam.org
            return {{"type", Word("outletPhaseMeanVelocity")},
                    {"alpha", Word("alpha.water")},
                    {"Umean", tail ? tail->speed : speed},
                    {"UnMean", tail ? tail->speed : speed},
                    {"value", stream}};
        return {{"type", Word("pressureInletOutletVelocity")}, {"tangentialVelocity", stream}, {"value", stream}};
    };
    const Dictionary wall{{"type", Word(plan.no_slip ? "noSlip" : "slip")}};
    return field(plan, "volVectorField", "U", velocity, inside, open, wall, [&](const Solid& s) -> Dictionary {
        const bool lets_go = !plan.wall_library.empty();
        // slip would let the water through a wall that moves
        if (s.moves) return {{"type", Word(plan.flavour.moving_wall(lets_go))}, {"value", uniform(Vec3::Zero())}};
        const FvmOptions& fvm = plan.scene->fvm;
        const bool short_steps = s.is_hull && std::min(fvm.max_courant, fvm.max_alpha_courant) <= 1;  // decision 061
        if (short_steps && !plan.no_slip) return {{"type", Word(plan.flavour.slip_wall(lets_go))}};
        return wall;
    });
}

/// 0/p_rgh: pressure less the hydrostatic part rho g z.
std::string p_rgh(const CasePlan& plan) {
    const auto open = [](const Patch& p) -> Dictionary {
        const Side side = p.side;
        if (side == Side::inlet || p.open == Patch::Open::resting_water)
            return {{"type", Word("fixedFluxPressure")}, {"value", uniform(0.0)}};
        if (side == Side::outlet) return {{"type", Word("zeroGradient")}};
        return {{"type", Word("totalPressure")}, {"p0", uniform(0.0)}, {"value", uniform(0.0)}};
    };
    const auto wall = [](const char* type) { return Dictionary{{"type", Word(type)}, {"value", uniform(0.0)}}; };
    return field(
        plan, "volScalarField", "p_rgh", pressure, uniform(0.0), open, wall("fixedFluxPressure"),
        [&](const Solid&) { return wall(plan.wall_library.empty() ? "fixedFluxPressure" : "ventilatedWallPressure"); });
}

/// 0/k, omega, nut. nutUSpaldingWallFunction holds from the wall to the logarithmic layer; nutkWallFunction loses 80 %
/// of the friction in a clean stream (measured).
std::vector<CaseFile> turbulence_fields(const CasePlan& plan) {
    if (!plan.turbulent) return {};
    const auto clean_stream = [](double v) {
        return [v](const Patch& p) -> Dictionary {
            if (p.side == Side::inlet) return {{"type", Word("fixedValue")}, {"value", uniform(v)}};
            return {{"type", Word("inletOutlet")}, {"inletValue", uniform(v)}, {"value", uniform(v)}};
        };
    };
    const auto calculated = [](const Patch&) -> Dictionary {
        return {{"type", Word("calculated")}, {"value", uniform(0.0)}};
    };
    const auto wall = [](const char* type, double v) {
        return Dictionary{{"type", Word(type)}, {"value", uniform(v)}};
    };
    const double k = plan.inlet_k, omega = plan.inlet_omega;
    return {{"0.orig/k", field(plan, "volScalarField", "k", specific_energy, uniform(k), clean_stream(k),
                               wall("kqRWallFunction", k))},
            {"0.orig/omega", field(plan, "volScalarField", "omega", per_second, uniform(omega), clean_stream(omega),
                                   wall("omegaWallFunction", omega))},
            {"0.orig/nut", field(plan, "volScalarField", "nut", diffusivity, uniform(k / omega), calculated,
                                 wall("nutUSpaldingWallFunction", 0))}};
}

}  // namespace tw

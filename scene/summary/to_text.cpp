#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "base/numbers.h"
#include "methods/methods.h"
#include "methods/names.h"
#include "record/influence_words.h"
#include "scene/box/box_walls.h"
#include "scene/box/forcing_zones.h"
#include "scene/box/tank_walls.h"
#include "scene/box/tank_wave.h"
#include "scene/cost/program_memory.h"
#include "scene/defaults.h"
#include "scene/doubtful_input.h"
#include "scene/mesh/edge_refinement.h"
#include "scene/mesh/mesh_motion.h"
#include "scene/particles/cost_of_sizes.h"
#include "scene/particles/particle_levels.h"
#include "scene/refined_places.h"
#include "scene/scene.h"
#include "scene/solids/thin_jet.h"
#include "scene/summary/solids_text.h"
#include "scene/summary/wave_text.h"
#include "scene/water/afloat.h"
#include "scene/water/struck_plate.h"
#include "scene/water/tailwater.h"
#include "scene/water/water_at_start.h"
#include "text/plain_number.h"
#include "text/units.h"

namespace tw {
namespace {

std::string side_name(Side side, bool holds_water) {
    switch (side) {
        case Side::slip_wall: return holds_water ? "no-slip wall" : "slip wall";
        case Side::symmetry: return "symmetry";
        case Side::inlet: return "inlet";
        case Side::outlet: return "outlet";
        case Side::atmosphere: return "atmosphere";
    }
    return "";
}

/// Whether the scene asks for runs by a method; what the others would take is predicted as well.
bool is_run(const std::string& method, const Scene& scene) {
    return std::ranges::find(scene.run.methods, method) != scene.run.methods.end();
}

/// What the oscillation after the start asks of the duration, and what that costs.
std::string start_up_text(const Scene& scene, const Prediction& p) {
    const double period = start_up_period(scene), wanted = default_duration(scene);
    if (!(period > 0)) return {};
    const double L_over_U = time_scale(scene), duration = scene.run.duration;
    std::string out = fmt::format(
        "  note      the start leaves an oscillation of {:.3g} s in the drag of a hull below Froude number 1 (8 pi "
        "U/g, "
        "no\n            longer than at Froude number 0.5); ",
        period);
    if (duration < wanted * (1 - 1e-9))
        return out + fmt::format(
                         "a settled mean needs a run of about {:.3g} s: this one\n            may give no drag; one "
                         "of {:.2g} times its cost would\n",
                         wanted, wanted / duration);
    const double planing = scene.motion.ramp + 3 * L_over_U, last = scene.run.stops_when_settled() ? wanted : duration,
                 rest = (last - planing) / duration;
    if (!(rest > 0)) return out + "the run is long enough for it\n";
    out +=
        fmt::format("waiting for one and averaging over three takes {:.0f} % of this\n            run: ", 100 * rest);
    const char* between = "";
    for (const MethodCost& cost : p.costs) {
        if (!is_run(cost.method, scene)) continue;
        out += fmt::format("{}{} {}", between, cost.method, time_in_words(rest * cost.seconds));
        between = ", ";
    }
    return out + "\n";
}

/// Of particles that run into finer zones, and one line for each of several sizes of them.
std::string sizes_text(const Scene& scene, const Prediction& p, const MethodCost& cost) {
    std::string out;
    if (p.most_particles > p.particles)
        out += fmt::format(
            "       water runs into the finer zones: {} particles at the start, {} in the mean (time), up to {} "
            "(memory)\n",
            plain_number(p.particles_at_start, 2), plain_number(p.particles, 2), plain_number(p.most_particles, 2));
    const std::vector<CostOfSize> sizes = cost_of_sizes(scene, p, cost);
    if (sizes.size() < 2) return out;
    out += "       particles      all = active + buffer + overlap      memory  of the time     time step\n";
    for (const CostOfSize& s : sizes) {
        const ParticlesOfSize& n = s.particles;
        out += fmt::format("       {:7.4g} m {:>8} {:>8} {:>8}  {:>8} {:8.3g} MB {:10.0f} % {:>11} s\n", n.spacing,
                           plain_number(n.all()), plain_number(n.active), plain_number(n.guards),
                           plain_number(n.parents), s.bytes / 1e6, 100 * s.seconds / cost.seconds, plain_number(s.dt));
    }
    return out;
}

/// Whether splash will be judged, and what would do where not.
std::string jet_text(const Scene& scene) {
    const std::optional<SprayJet> jet = thin_jet(scene);
    if (!jet) return {};
    const std::string why = jet->why_not_resolved();
    return fmt::format("  {:13} about {:.2g} m thick where it leaves the hull, by {}; {}\n", "spray jet",
                       jet->thickness, scene.hull->section ? "free streamlines without gravity" : "thin-jet theory",
                       why.empty() ? fmt::format("resolved by {:.2g} spacings", jet->across())
                                   : why + "; no height of splash is judged");
}

/// `where`: how much of the box.
std::string zone_line(double size, const std::string& where, const Box& box, const Domain& d) {
    return fmt::format("  {:13} {:.4g} m {}in {} to {} m, twice that outside (sph only)\n", "particles", size, where,
                       place_text(box.min.cwiseMax(d.box.min)), place_text(box.max.cwiseMin(d.box.max)));
}

/// What the zones of a stream take of a run, beside the same scene without them.
std::string cost_of_zones(const Scene& scene, const Prediction& p) {
    if (scene.motion.kind != Motion::Kind::stream) return {};
    Scene without = scene;
    without.domain.box = scene.domain.undamped;
    without.sph.zones = "fine";
    std::erase_if(without.effects, [](const EffectChoice& e) { return e.name == "forcing_zones"; });
    const Prediction less = predict_sizes(without);
    return fmt::format(
        "  {:13} they make {:.3g} particles of {:.3g} and {:.3g} cells of {:.3g} (+{:.0f} and +{:.0f} %)\n", "",
        p.particles, less.particles, p.cells, less.cells, 100 * (p.particles / less.particles - 1),
        100 * (p.cells / less.cells - 1));
}

/// One line for each zone, why they are so, and what they cost.
std::string zones_text(const Scene& scene, const Prediction& p) {
    const ForcingZones plan = forcing_zones(scene);
    std::string out;
    for (const ForcingZone& z : plan.zones)
        out += fmt::format("  {:13} {:.4g} m wide, {} from {:.4g} m to {:.4g} m, gamma {:.3g} 1/s\n",
                           &z == plan.zones.data() ? "zones" : "", std::abs(z.end - z.begin), "xy"[z.axis], z.begin,
                           z.end, z.gamma);
    if (!plan.zones.empty()) out += fmt::format("  {:13} {}\n", "", plan.why) + cost_of_zones(scene, p);
    return out;
}

void add_line(std::string& out, const std::string& label, const std::string& sentence) {
    if (!sentence.empty()) out += label + sentence + "\n";
}

std::string solids_text(const Scene& scene) {
    std::string out;
    if (scene.hull) out += hull_text(*scene.hull);
    for (const Obstacle& o : scene.obstacles) {
        const Box b = o.surface.bounds();
        out += fmt::format("obstacle    {}: {} to {} m\n", o.name, place_text(b.min), place_text(b.max));
    }
    if (scene.tank_motion) {
        out += "tank        places, velocities and forces are in its own axes\n" + law_text(scene.tank_motion->law);
        if (scene.tank_motion->law.turns)
            out += fmt::format("            through {} m\n", place_text(scene.tank_motion->pivot));
    }
    for (const MovingBody& b : scene.bodies) out += body_text(b, scene);
    if (is_run(fvm_method, scene)) add_line(out, "  fvm       ", mesh_motion(scene).sentence());
    return out;
}

/// Where the water is at the start, what it is, and how it moves.
std::string water_text(const Scene& scene) {
    std::string out;
    for (const Box& b : scene.water_blocks)
        out += fmt::format("water       block {} to {} m\n", place_text(b.min), place_text(b.max));
    for (const std::string& sentence : water_at_start(scene)) add_line(out, "  at start  ", sentence);
    const Water& w = scene.water;
    out += fmt::format("water       {:.4g} m deep, {:.5g} kg/m³, nu {:.3g} m²/s, sigma {:.3g} N/m, g {:.4g} m/s²\n",
                       w.depth, w.density, w.kinematic_viscosity, w.surface_tension, w.gravity);
    if (scene.motion.kind == Motion::Kind::stream)
        out += fmt::format("motion      stream of {:.4g} m/s along x, started over {:.3g} s\n", scene.motion.speed,
                           scene.motion.ramp);
    if (const auto tail = tailwater(scene))
        out += fmt::format("            behind x = {:.4g} m it starts {:.4g} m deep with {:.4g} m/s\n", tail->begins,
                           tail->depth, tail->speed);
    if (scene.motion.kind != Motion::Kind::stream && !scene.has_wave())
        out += "motion      none: the water is at rest at the start\n";
    out += wave_text(scene);
    for (const Finding& f : doubtful_input(scene)) out += fmt::format("  warning   {}: {}\n", f.name, f.message);
    return out;
}

std::string domain_text(const Scene& scene, const Prediction& p) {
    const Domain& d = scene.domain;
    const auto side = [holds = tank_holds_water(scene)](Side s) { return side_name(s, holds); };
    std::string out = fmt::format("domain      {} to {} m, {} dimensions; x: {}, {}; y: {}, {}; z: {}, {}\n",
                                  place_text(d.box.min), place_text(d.box.max), d.dimensions, side(d.x_min),
                                  side(d.x_max), side(d.y_min), side(d.y_max), side(d.z_min), side(d.z_max));
    out += zones_text(scene, p);
    add_line(out, "  warning   ", wall_warning(scene));
    if (const std::string channel = channel_text(scene); !channel.empty())
        out += "  channel   the values are those of " + channel + "\n";
    return out;
}

/// The zones of finer particles, each with the box that it reaches.
std::string particle_zones_text(const Scene& scene) {
    std::string out;
    const std::vector<Zone> zones = particle_zones(scene);
    for (std::size_t k = 0; k < zones.size(); ++k) {
        const std::vector<Box>& boxes = zones[k].boxes();
        const bool follows = zones[k].follows_surface();
        const double size = std::ldexp(finest_spacing(scene), static_cast<int>(zones.size() - k) - 1);
        if (follows)
            out +=
                zone_line(size, fmt::format("within {:.3g} m of the hull, ", zones[k].width()), boxes[0], scene.domain);
        if (const std::span<const Box> rest = std::span(boxes).subspan(follows ? 1 : 0); !rest.empty()) {
            Box all = rest.front();
            for (const Box& box : rest) all = {all.min.cwiseMin(box.min), all.max.cwiseMax(box.max)};
            out += zone_line(size, rest.size() > 1 ? fmt::format("in {} boxes ", rest.size()) : "", all, scene.domain);
        }
    }
    return out;
}

std::string resolution_text(const Scene& scene) {
    std::string out = fmt::format(
        "resolution  {:.4g} m at the hull (particles, finest cells), {:.4g} m far from it (largest cells)\n",
        scene.resolution.near_hull, scene.resolution.spacing);
    for (const RefinementBox& r : scene.refinement)
        out += fmt::format("  {:13} {:.4g} m cells in {} to {} m\n", r.name, scene.resolution.spacing / (1 << r.level),
                           place_text(r.box.min), place_text(r.box.max));
    add_line(out, "  note      ", why_one_size_afloat(scene));
    out += particle_zones_text(scene);
    if (const EdgeRefinement shedding = edge_refinement(scene); !shedding.edges.empty())
        out += fmt::format("  {:13} {:.4g} m cells along {:.3g} m of edges from which the water leaves (fvm only)\n",
                           "edges", scene.resolution.near_hull / (1 << shedding.halvings), length_of(shedding.edges));
    return out + jet_text(scene);
}

std::string sampling_text(const Scene& scene, const Prediction& p) {
    const Sampling& s = scene.sampling;
    std::string out = fmt::format("sampling    every {:.4g} s into {} x {} x {} voxels of {:.4g} m; ", s.interval,
                                  s.raster.count[0], s.raster.count[1], s.raster.count[2], s.raster.voxel);
    if (s.mean_from > 0) out += fmt::format("means from {:.4g} s; ", s.mean_from);
    out += fmt::format("{} pressure and {} height probes\n", s.pressure.size(), s.height.size());
    for (const WaterBox& v : s.volumes)
        out += fmt::format("volume      {}: the water in {} to {} m\n", v.name,
                           place_text(v.box.min.cwiseMax(scene.domain.box.min)),
                           place_text(v.box.max.cwiseMin(scene.domain.box.max)));
    for (const MeasuredValue& m : scene.measured)
        out += fmt::format("measured    {} {:.6g} {} ({})\n", m.quantity, m.value / parse_unit(m.unit).factor, m.unit,
                           m.source);
    if (scene.measured_of_others > 0)
        out += fmt::format("measured    {} values of other speeds, waves, hulls or trims are left out\n",
                           scene.measured_of_others);
    if (p.snapshots > 0) out += fmt::format("  snapshots {:.0f} sets of ParaView files\n", p.snapshots);
    return out;
}

/// How long it runs, and what speaks against a mean from it.
std::string run_text(const Scene& scene, const Prediction& p) {
    std::string out = fmt::format(
        "run         {}{:.4g} s{}, particle sound speed {:.4g} m/s{}\n",
        scene.run.stops_when_settled() ? "at most " : "", scene.run.duration,
        scene.run.stops_when_settled() ? ", until drag, lift and trim moment have settled" : "", scene.sph.c0,
        water_strikes_plate(scene)
            ? fmt::format(", the water falls at up to {:.4g} m/s, with faster jets, because it hits an elastic plate",
                          explained_speed(scene))
            : "");
    if (scene.sampling.mean_from > 0 && scene.run.duration <= scene.sampling.mean_from)
        out += "  note      the run ends before the means begin: no settled mean can be given\n";
    out += start_up_text(scene, p);
    if (const double mach = 0.1 * default_sound_speed(scene) / scene.sph.c0; mach > 0.15)
        out += fmt::format(
            "  warning   the water moves at {:.2g} times this sound speed, which compresses it by about {:.0f} %; "
            "raise [sph] c0\n",
            mach, 50 * mach * mach);
    return out;
}

std::string effects_planned(const Scene& scene) {
    std::string out;
    for (const EffectChoice& e : scene.effects)
        out += fmt::format(
            "  {:16} {:3} {}: {}\n{:24}influence: {}{}\n", e.name, e.on ? "on" : "off",
            e.forced ? "(as requested)" : "(auto)", e.reason, "",
            influence_in_words(e.influence, scene.motion.kind == Motion::Kind::stream),
            e.cost > 0 ? fmt::format("; cost {} {:.0f} % of a particle run", e.on ? "is" : "would be", 100 * e.cost)
                       : "");
    return out;
}

std::string cost_text(const Scene& scene, const Prediction& p) {
    std::string out;
    for (const MethodCost& cost : p.costs) {
        if (!is_run(cost.method, scene)) continue;
        out += fmt::format("  {:4} {}, {} steps, {:.2g} GB, {}\n", cost.method, cost.in_words, plain_number(cost.steps),
                           all_bytes(scene, cost) / 1e9, time_in_words(cost.seconds));
        if (elements_of(cost.method) == "particles") out += sizes_text(scene, p, cost);
    }
    return out;
}

}  // namespace

std::string to_text(const Scene& scene, const Prediction& p) {
    return scene.title + "\n\n" +  //
           solids_text(scene) + water_text(scene) + domain_text(scene, p) + resolution_text(scene) +
           sampling_text(scene, p) + run_text(scene, p) +  //
           "\neffects\n" + effects_planned(scene) +
           fmt::format(
               "\npredicted for this machine (two significant digits at best; drawing the report takes {:.2g} "
               "GB at least)\n",
               bytes_of_report / 1e9) +
           cost_text(scene, p) + "\nscene hash  " + scene.hash + "\n";
}

}  // namespace tw

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "base/numbers.h"
#include "motion/table_motion.h"
#include "record/influence_words.h"
#include "scene/box/box_walls.h"
#include "scene/box/forcing_zones.h"
#include "scene/box/tank_walls.h"
#include "scene/box/tank_wave.h"
#include "scene/defaults.h"
#include "scene/doubtful_input.h"
#include "scene/mesh/edge_refinement.h"
#include "scene/mesh/mesh_motion.h"
#include "scene/particles/cost_of_sizes.h"
#include "scene/particles/particle_levels.h"
#include "scene/refined_places.h"
#include "scene/scene.h"
#include "scene/solids/thin_jet.h"
#include "scene/solids/walls_met.h"
#include "scene/water/afloat.h"
#include "scene/water/struck_plate.h"
#include "scene/water/tailwater.h"
#include "scene/water/water_at_start.h"
#include "scene/wave_text.h"
#include "structure/shell/shell.h"
#include "structure/solid/solid.h"
#include "text/plain_degrees.h"
#include "text/plain_number.h"
#include "text/units.h"

namespace tw {
namespace {

// + 0.0: minus zero is zero
std::string place(const Vec3& p) {
    return fmt::format("({:.4g}, {:.4g}, {:.4g})", p.x() + 0.0, p.y() + 0.0, p.z() + 0.0);
}

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

std::string free_hull_text(const FreeHull& free, const std::string& unit_of_mass) {
    const RigidBodySetup& m = free.motion;
    std::string out = fmt::format(
        "  free      in {}{}{} from {:.4g} s on, surge held: mass {:.5g} {}, centre at {} m, radius of gyration {:.4g} "
        "m\n",
        m.free.along[2] ? "heave" : "", m.free.along[2] && m.free.about[1] ? " and " : "",
        m.free.about[1] ? "pitch" : "", m.release, m.mass.mass, unit_of_mass, place(m.mass.centre),
        std::sqrt(m.mass.inertia(1, 1) / m.mass.mass));
    if (free.at_rest)
        out += fmt::format("  at rest   it floats {:.4g} m {} where it stands, its bow turned {} by {} deg\n",
                           std::abs(free.at_rest->rise), free.at_rest->rise < 0 ? "below" : "above",
                           free.at_rest->turn < 0 ? "down" : "up", plain_degrees(std::abs(free.at_rest->turn)));
    return out;
}

std::string hull_text(const Hull& h) {
    std::string out = fmt::format(
        "hull        {}: {:.4g} m long, {}; trim {} deg, draft {:.4g} m{}\n", h.source, h.length,
        h.section ? "its section with y = 0, results are per metre of span" : fmt::format("{:.4g} m wide", h.beam),
        plain_degrees(h.trim), h.draft, h.half ? "; one half is solved, results are for the whole hull" : "");
    out += fmt::format(
        "            it displaces {:.4g} {} at rest and is wetted from x = {:.4g} to {:.4g} m; {} triangles\n",
        h.still.volume, h.section ? "m3 per metre" : "m3", h.still.wet_bounds.min.x(), h.still.wet_bounds.max.x(),
        h.surface.triangles.size());
    if (h.free) out += free_hull_text(*h.free, h.section ? "kg/m" : "kg");
    for (const std::string& r : h.repairs) out += "  repaired  " + r + "\n";
    for (const Finding& f : h.findings)
        out += fmt::format("  {:9} {}: {}\n", f.level == Finding::Level::note ? "note" : "warning", f.name, f.message);
    if (h.findings.empty())
        out += "            the surface is closed, its normals point outward, and nothing was found wrong with it\n";
    return out;
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

std::string findings_text(const std::vector<Finding>& findings) {
    std::string out;
    for (const Finding& f : findings)
        out += fmt::format("  {:9} {}\n", f.level == Finding::Level::warning ? "warning" : "note", f.message);
    return out;
}

std::string plate_text(const MovingBody& b, const Scene& scene) {
    const ElasticPlate& p = *b.plate();
    const structure::Laminate laminate(p.plies);
    const double explicit_step = shell_of(p, p.cell()).explicit_step(), dp = scene.resolution.near_hull,
                 sound = scene.sph.cfl * scene.sph.h_over_dp * dp / scene.sph.c0,
                 spring = 2 * dp / (scene.sph.c0 * std::sqrt(scene.water.density * dp / laminate.areal_mass()));
    std::string out = fmt::format(
        "  elastic   {} elements of at most {:.3g} m, {:.4g} kg/m2, D11 {:.4g}, D22 {:.4g} N m; {}; {} rotations\n",
        p.elements(), p.cell(), laminate.areal_mass(), laminate.D()(0, 0), laminate.D()(1, 1), p.supports(),
        p.large_rotations ? "large" : "small");
    if (p.total_mass > 0)
        out += fmt::format("  mass      {:.5g} {} with the frame; at the start {} m/s\n", p.total_mass,
                           scene.spanwise_unit("kg"), place(p.velocity));
    out += fmt::format(
        "  time      average acceleration, implicit, in the water's steps: sound allows {:.3g} s, water on the plate "
        "{:.3g} s{}; explicit steps could be no longer than {:.3g} s\n",
        sound, spring, p.largest_step > 0 ? fmt::format(", structure_step {:.3g} s", p.largest_step) : "",
        explicit_step);
    for (const ElasticGauge& g : p.gauges)
        out +=
            fmt::format("  gauge     {}: {} at {} m\n", g.name,
                        g.direction ? fmt::format("strain along {}, {}", place(*g.direction), g.top ? "top" : "bottom")
                                    : "displacement",
                        place(g.position));
    return out + findings_text(b.findings);
}

std::string tyre_text(const MovingBody& b) {
    const ElasticTyre& t = *b.tyre();
    const structure::Solid solid = solid_of(t);
    const double height = b.surface.bounds().size().z();
    std::string out = fmt::format(
        "  elastic   {} hexahedra; inflated by {:.4g} Pa to {:.4g} mm from {:.4g} mm\n"
        "  mass      {:.5g} kg with rim and load; at the start {} m/s\n"
        "  time      explicit, the water's steps cut into sub-steps below {:.3g} s, the elements' limit\n"
        "  floor     met without friction; 1 MPa presses the rubber {:.3g} mm into it\n",
        solid.elements().size(), t.pressure, 1000 * height, 1000 * t.shape.outer_diameter, t.total_mass,
        place(t.velocity), solid.explicit_step(Eigen::VectorXd::Zero(solid.dofs())), 1000 * t.contact_depth);
    return out + findings_text(b.findings);
}

std::string law_text(const MotionLaw& law) {
    static constexpr const char* kinds[] = {"constant rate", "ramp", "sinusoid", "table"};
    const char* const unit = law.turns ? "rad" : "m";
    std::string out = fmt::format("  moves     as prescribed ({}) {} {}, at most {:.4g} {}/s and {:.4g} {}/s2\n",
                                  kinds[static_cast<int>(law.kind)], law.turns ? "about" : "along", place(law.axis),
                                  law.fastest(), unit, largest_acceleration(law), unit);
    if (law.kind != MotionLaw::Kind::table) return out;
    const EndsOfTable ends = ends_of_table(law.times, law.values);
    const auto how = [&](double rate) {
        return rate == 0 ? std::string("at rest") : fmt::format("at {:.4g} {}/s", rate, unit);
    };
    return out + fmt::format(
                     "  table     {} rows, at most {:.4g} {}/s from row to row; it begins {} and ends at {:.4g} s {}\n",
                     law.times.size(), largest_of_table(law.times, law.values).from_row_to_row, unit, how(ends.begin),
                     law.times.back(), how(ends.end));
}

std::string contact_text(const MovingBody& b, const Scene& scene) {
    if (walls_met(b, scene).empty()) return {};
    std::string touched;
    for (const MetWall& wall : walls_touched(b, scene)) touched += (touched.empty() ? "" : " and ") + wall.name;
    return fmt::format("  contact   with floor and sides of the tank, friction {:.4g}, no rebound (particles){}\n",
                       b.friction, touched.empty() ? "" : fmt::format("; it starts on {}", touched));
}

std::string body_text(const MovingBody& b, const Scene& scene) {
    const RigidBodySetup& m = b.motion;
    const Box at = b.surface.bounds();
    std::string out = fmt::format("body        {}: {}, {} to {} m\n", b.name, b.source, place(at.min), place(at.max));
    if (b.tyre()) return out + tyre_text(b);
    if (b.elastic) return out + plate_text(b, scene);
    if (m.law) return out + law_text(*m.law);
    static constexpr const char* names[] = {"surge", "sway", "heave", "roll", "pitch", "yaw"};
    std::string free;
    for (std::size_t k = 0; k < 6; ++k)
        if (k < 3 ? m.free.along[k] : m.free.about[k - 3]) free += (free.empty() ? "" : ", ") + std::string(names[k]);
    out += fmt::format("  mass      {:.5g} {}, centre at {} m, inertia {:.4g}, {:.4g}, {:.4g} {}\n", m.mass.mass,
                       scene.spanwise_unit("kg"), place(m.mass.centre), m.mass.inertia(0, 0), m.mass.inertia(1, 1),
                       m.mass.inertia(2, 2), scene.spanwise_unit("kg m2"));
    out += fmt::format("  moves     freely in {}; at the start {} m/s, spin {} rad/s\n", free, place(m.velocity),
                       place(m.spin));
    return out + contact_text(b, scene) + findings_text(b.findings);
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
                       place(box.min.cwiseMax(d.box.min)), place(box.max.cwiseMin(d.box.max)));
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

}  // namespace

std::string to_text(const Scene& scene, const Prediction& p) {
    std::string out = scene.title + "\n\n";
    if (scene.hull) out += hull_text(*scene.hull);
    for (const Obstacle& o : scene.obstacles) {
        const Box b = o.surface.bounds();
        out += fmt::format("obstacle    {}: {} to {} m\n", o.name, place(b.min), place(b.max));
    }
    if (scene.tank_motion) {
        out += "tank        places, velocities and forces are in its own axes\n" + law_text(scene.tank_motion->law);
        if (scene.tank_motion->law.turns)
            out += fmt::format("            through {} m\n", place(scene.tank_motion->pivot));
    }
    for (const MovingBody& b : scene.bodies) out += body_text(b, scene);
    if (is_run("fvm", scene))
        if (const std::string mesh = mesh_motion(scene).sentence(); !mesh.empty()) out += "  fvm       " + mesh + "\n";
    for (const Box& b : scene.water_blocks)
        out += fmt::format("water       block {} to {} m\n", place(b.min), place(b.max));
    for (const std::string& sentence : water_at_start(scene)) out += "  at start  " + sentence + "\n";
    const Water& w = scene.water;
    out += fmt::format("water       {:.4g} m deep, {:.5g} kg/m3, nu {:.3g} m2/s, sigma {:.3g} N/m, g {:.4g} m/s2\n",
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
    const Domain& d = scene.domain;
    const auto side = [holds = tank_holds_water(scene)](Side s) { return side_name(s, holds); };
    out += fmt::format("domain      {} to {} m, {} dimensions; x: {}, {}; y: {}, {}; z: {}, {}\n", place(d.box.min),
                       place(d.box.max), d.dimensions, side(d.x_min), side(d.x_max), side(d.y_min), side(d.y_max),
                       side(d.z_min), side(d.z_max));
    out += zones_text(scene, p);
    if (const std::string walls = wall_warning(scene); !walls.empty()) out += "  warning   " + walls + "\n";
    if (const std::string channel = channel_text(scene); !channel.empty())
        out += "  channel   the values are those of " + channel + "\n";
    out += fmt::format(
        "resolution  {:.4g} m at the hull (particles, finest cells), {:.4g} m far from it (largest cells)\n",
        scene.resolution.near_hull, scene.resolution.spacing);
    for (const RefinementBox& r : scene.refinement)
        out += fmt::format("  {:13} {:.4g} m cells in {} to {} m\n", r.name, scene.resolution.spacing / (1 << r.level),
                           place(r.box.min), place(r.box.max));
    if (const std::string why = why_one_size_afloat(scene); !why.empty()) out += "  note      " + why + "\n";
    const std::vector<Zone> zones = particle_zones(scene);
    for (std::size_t k = 0; k < zones.size(); ++k) {
        const std::vector<Box>& boxes = zones[k].boxes();
        const bool follows = zones[k].follows_surface();
        const double size = std::ldexp(finest_spacing(scene), static_cast<int>(zones.size() - k) - 1);
        if (follows)
            out += zone_line(size, fmt::format("within {:.3g} m of the hull, ", zones[k].width()), boxes[0], d);
        if (const std::span<const Box> rest = std::span(boxes).subspan(follows ? 1 : 0); !rest.empty()) {
            Box all = rest.front();
            for (const Box& box : rest) all = {all.min.cwiseMin(box.min), all.max.cwiseMax(box.max)};
            out += zone_line(size, rest.size() > 1 ? fmt::format("in {} boxes ", rest.size()) : "", all, d);
        }
    }
    if (const EdgeRefinement shedding = edge_refinement(scene); !shedding.edges.empty())
        out += fmt::format("  {:13} {:.4g} m cells along {:.3g} m of edges from which the water leaves (fvm only)\n",
                           "edges", scene.resolution.near_hull / (1 << shedding.halvings), length_of(shedding.edges));
    out += jet_text(scene);
    const Sampling& s = scene.sampling;
    out += fmt::format("sampling    every {:.4g} s into {} x {} x {} voxels of {:.4g} m; ", s.interval,
                       s.raster.count[0], s.raster.count[1], s.raster.count[2], s.raster.voxel);
    if (s.mean_from > 0) out += fmt::format("means from {:.4g} s; ", s.mean_from);
    out += fmt::format("{} pressure and {} height probes\n", s.pressure.size(), s.height.size());
    for (const MeasuredValue& m : scene.measured)
        out += fmt::format("measured    {} {:.6g} {} ({})\n", m.quantity, m.value / parse_unit(m.unit).factor, m.unit,
                           m.source);
    if (p.snapshots > 0) out += fmt::format("  snapshots {:.0f} sets of ParaView files\n", p.snapshots);
    out += fmt::format(
        "run         {}{:.4g} s{}, particle sound speed {:.4g} m/s{}\n",
        scene.run.stops_when_settled() ? "at most " : "", scene.run.duration,
        scene.run.stops_when_settled() ? ", until drag, lift and trim moment have settled" : "", scene.sph.c0,
        water_strikes_plate(scene)
            ? fmt::format(", the water falls at up to {:.4g} m/s, with faster jets, because it hits an elastic plate",
                          explained_speed(scene))
            : "");
    if (s.mean_from > 0 && scene.run.duration <= s.mean_from)
        out += "  note      the run ends before the means begin: no settled mean can be given\n";
    out += start_up_text(scene, p);
    if (const double mach = 0.1 * default_sound_speed(scene) / scene.sph.c0; mach > 0.15)
        out += fmt::format(
            "  warning   the water moves at {:.2g} times this sound speed, which compresses it by about {:.0f} %; "
            "raise [sph] c0\n",
            mach, 50 * mach * mach);
    out += "\neffects\n";
    for (const EffectChoice& e : scene.effects)
        out += fmt::format(
            "  {:16} {:3} {}: {}\n{:24}influence: {}{}\n", e.name, e.on ? "on" : "off",
            e.forced ? "(as requested)" : "(auto)", e.reason, "",
            influence_in_words(e.influence, scene.motion.kind == Motion::Kind::stream),
            e.cost > 0 ? fmt::format("; cost {} {:.0f} % of a particle run", e.on ? "is" : "would be", 100 * e.cost)
                       : "");
    out += fmt::format(
        "\npredicted for this machine (two significant digits at best; drawing the report takes {:.2g} GB at least)\n",
        bytes_of_report / 1e9);
    for (const MethodCost& cost : p.costs) {
        if (!is_run(cost.method, scene)) continue;
        out += fmt::format("  {:4} {}, {} steps, {:.2g} GB, {}\n", cost.method, cost.in_words, plain_number(cost.steps),
                           cost.bytes / 1e9, time_in_words(cost.seconds));
        if (elements_of(cost.method) == "particles") out += sizes_text(scene, p, cost);
    }
    out += "\nscene hash  " + scene.hash + "\n";
    return out;
}

}  // namespace tw

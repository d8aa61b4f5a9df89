#include "scene/summary/solids_text.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "motion/table_motion.h"
#include "scene/scene.h"
#include "scene/solids/walls_met.h"
#include "structure/shell/shell.h"
#include "structure/solid/solid.h"
#include "text/plain_degrees.h"

namespace tw {

// + 0.0: minus zero is zero
std::string place_text(const Vec3& p) {
    return fmt::format("({:.4g}, {:.4g}, {:.4g})", p.x() + 0.0, p.y() + 0.0, p.z() + 0.0);
}

namespace {

std::string free_hull_text(const FreeHull& free, const std::string& unit_of_mass) {
    const RigidBodySetup& m = free.motion;
    std::string out = fmt::format(
        "  free      in {}{}{} from {:.4g} s on, surge held: mass {:.5g} {}, centre at {} m, radius of gyration {:.4g} "
        "m\n",
        m.free.along[2] ? "heave" : "", m.free.along[2] && m.free.about[1] ? " and " : "",
        m.free.about[1] ? "pitch" : "", m.release, m.mass.mass, unit_of_mass, place_text(m.mass.centre),
        std::sqrt(m.mass.inertia(1, 1) / m.mass.mass));
    if (free.at_rest)
        out += fmt::format("  at rest   it floats {:.4g} m {} where it stands, its bow turned {} by {} deg\n",
                           std::abs(free.at_rest->rise), free.at_rest->rise < 0 ? "below" : "above",
                           free.at_rest->turn < 0 ? "down" : "up", plain_degrees(std::abs(free.at_rest->turn)));
    return out;
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
                           scene.spanwise_unit("kg"), place_text(p.velocity));
    out += fmt::format(
        "  time      average acceleration, implicit, in the water's steps: sound allows {:.3g} s, water on the plate "
        "{:.3g} s{}; explicit steps could be no longer than {:.3g} s\n",
        sound, spring, p.largest_step > 0 ? fmt::format(", structure_step {:.3g} s", p.largest_step) : "",
        explicit_step);
    for (const ElasticGauge& g : p.gauges)
        out += fmt::format("  gauge     {}: {} at {} m\n", g.name,
                           g.direction
                               ? fmt::format("strain along {}, {}", place_text(*g.direction), g.top ? "top" : "bottom")
                               : "displacement",
                           place_text(g.position));
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
        place_text(t.velocity), solid.explicit_step(Eigen::VectorXd::Zero(solid.dofs())), 1000 * t.contact_depth);
    return out + findings_text(b.findings);
}

std::string contact_text(const MovingBody& b, const Scene& scene) {
    if (walls_met(b, scene).empty()) return {};
    std::string touched;
    for (const MetWall& wall : walls_touched(b, scene)) touched += (touched.empty() ? "" : " and ") + wall.name;
    return fmt::format("  contact   with floor and sides of the tank, friction {:.4g}, no rebound (particles){}\n",
                       b.friction, touched.empty() ? "" : fmt::format("; it starts on {}", touched));
}

}  // namespace

std::string hull_text(const Hull& h) {
    std::string out = fmt::format(
        "hull        {}: {:.4g} m long, {}; trim {} deg, draft {:.4g} m{}\n", h.source, h.length,
        h.section ? "its section with y = 0, results are per metre of span" : fmt::format("{:.4g} m wide", h.beam),
        plain_degrees(h.trim), h.draft, h.half ? "; one half is solved, results are for the whole hull" : "");
    out += fmt::format(
        "            it displaces {:.4g} {} at rest and is wetted from x = {:.4g} to {:.4g} m; {} triangles\n",
        h.still.volume, h.section ? "m³ per metre" : "m³", h.still.wet_bounds.min.x(), h.still.wet_bounds.max.x(),
        h.surface.triangles.size());
    if (h.free) out += free_hull_text(*h.free, h.section ? "kg/m" : "kg");
    for (const std::string& r : h.repairs) out += "  repaired  " + r + "\n";
    for (const Finding& f : h.findings)
        out += fmt::format("  {:9} {}: {}\n", f.level == Finding::Level::note ? "note" : "warning", f.name, f.message);
    if (h.findings.empty())
        out += "            the surface is closed, its normals point outward, and nothing was found wrong with it\n";
    return out;
}

std::string law_text(const MotionLaw& law) {
    static constexpr const char* kinds[] = {"constant rate", "ramp", "sinusoid", "table"};
    const char* const unit = law.turns ? "rad" : "m";
    std::string out = fmt::format("  moves     as prescribed ({}) {} {}, at most {:.4g} {}/s and {:.4g} {}/s2\n",
                                  kinds[static_cast<int>(law.kind)], law.turns ? "about" : "along",
                                  place_text(law.axis), law.fastest(), unit, largest_acceleration(law), unit);
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

std::string body_text(const MovingBody& b, const Scene& scene) {
    const RigidBodySetup& m = b.motion;
    const Box at = b.surface.bounds();
    std::string out =
        fmt::format("body        {}: {}, {} to {} m\n", b.name, b.source, place_text(at.min), place_text(at.max));
    if (b.tyre()) return out + tyre_text(b);
    if (b.elastic) return out + plate_text(b, scene);
    if (m.law) return out + law_text(*m.law);
    static constexpr const char* names[] = {"surge", "sway", "heave", "roll", "pitch", "yaw"};
    std::string free;
    for (std::size_t k = 0; k < 6; ++k)
        if (k < 3 ? m.free.along[k] : m.free.about[k - 3]) free += (free.empty() ? "" : ", ") + std::string(names[k]);
    out += fmt::format("  mass      {:.5g} {}, centre at {} m, inertia {:.4g}, {:.4g}, {:.4g} {}\n", m.mass.mass,
                       scene.spanwise_unit("kg"), place_text(m.mass.centre), m.mass.inertia(0, 0), m.mass.inertia(1, 1),
                       m.mass.inertia(2, 2), scene.spanwise_unit("kg m2"));
    out += fmt::format("  moves     freely in {}; at the start {} m/s, spin {} rad/s\n", free, place_text(m.velocity),
                       place_text(m.spin));
    return out + contact_text(b, scene) + findings_text(b.findings);
}

}  // namespace tw

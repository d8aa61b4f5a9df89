#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "meshes/mass_properties.h"
#include "scene/elastic/tyre_steps.h"
#include "scene/read/read.h"
#include "structure/degrees_of_freedom.h"
#include "structure/solid/wet_surface.h"
#include "structure/tyre_static.h"

namespace tw {
namespace {

structure::Hyperelastic read_rubber(SceneSection& s, const char* key, const Vec3& fallback, double density) {
    const Vec3 c = s.vector(key).value_or(fallback);
    const auto rubber = structure::Hyperelastic::mooney_rivlin(c[0], c[1], c[2], density);
    if (const std::string why = structure::impossible(rubber); !why.empty())
        s.fail(key, "no rubber has these constants [C10, C01, bulk modulus]: " + why);
    return rubber;
}

void read_start(SceneSection& s, ElasticTyre& tyre, double gravity) {
    const auto fall = s.number("drop_height");
    if (fall && s.has("velocity"))
        s.fail("drop_height", "gives the velocity that a fall ends with; keep one of the two");
    tyre.velocity =
        fall ? Vec3(0, 0, -std::sqrt(2 * gravity * *fall)) : s.vector("velocity").value_or(Vec3(Vec3::Zero()));
    const auto at = s.numbers("position");
    if (at) tyre.axle = Vec3((*at)[0], (*at)[1], 0);
    static constexpr const char* names[] = {"surge", "sway", "heave"};
    for (const std::string& word : s.choices("locked").value_or(std::vector<std::string>{})) {
        const auto found = std::ranges::find(names, word);
        if (found == std::end(names))
            s.fail("locked", fmt::format("'{}': a tyre's rim does not turn; expected surge, sway or heave", word));
        tyre.locked[static_cast<std::size_t>(found - std::begin(names))] = true;
    }
}

}  // namespace

ElasticTyre read_tyre(SceneSection& s, int dimensions, double gravity) {
    if (dimensions == 2) s.fail("elastic", "a tyre has three dimensions; expected [domain] dimensions = 3");
    ElasticTyre tyre;
    structure::Tyre& shape = tyre.shape;
    const Vec3 size = s.vector("tyre").value_or(Vec3(shape.outer_diameter, shape.rim_diameter, shape.width)),
               walls =
                   s.vector("walls").value_or(Vec3(shape.tread_thickness, shape.side_thickness, shape.inner_thickness));
    shape.outer_diameter = size[0], shape.rim_diameter = size[1], shape.width = size[2];
    shape.tread_thickness = walls[0], shape.side_thickness = walls[1], shape.inner_thickness = walls[2];
    if (const auto cells = s.numbers("cells")) {
        if ((*cells)[0] != std::floor((*cells)[0]) || (*cells)[1] != std::floor((*cells)[1]) ||
            !((*cells)[0] <= 1000 && (*cells)[1] <= 1000))
            s.fail("cells", "expected whole numbers of elements around and across, at most 1000");
        shape.around = static_cast<int>((*cells)[0]), shape.across = static_cast<int>((*cells)[1]);
    }
    const double density = s.number("density", 1100.0);
    tyre.rubber = {read_rubber(s, "inner_tyre", structure::assumed_inner_tyre, density),
                   read_rubber(s, "sidewall", structure::calibrated_sidewall, density),
                   read_rubber(s, "tread", structure::calibrated_tread, density)};
    tyre.pressure = s.number("pressure", 1.38e5);
    const auto mass = s.number("mass");
    if (!mass) s.fail("mass", "missing; a tyre needs the mass of tyre, rim and load together");
    tyre.total_mass = *mass;
    tyre.contact_depth = s.number("contact_depth", 1e-4);
    tyre.damping = s.number("damping", 0.0);
    tyre.largest_step = s.number("structure_step", 0.0);
    read_start(s, tyre, gravity);
    return tyre;
}

void read_tyre_body(SceneSection& s, MovingBody& b, ElasticTyre tyre) {
    b.source = fmt::format("elastic tyre of {:.4g} mm", 1000 * tyre.shape.outer_diameter);
    for (const ElasticGauge& gauge : tyre.gauges)
        if (gauge.direction)
            s.fail("name", fmt::format("gauge {}: a tyre has no strain gauges; remove its direction", gauge.name));
    const auto draft = s.number("draft");
    if (!draft)
        s.fail("draft", "missing; expected the depth of the tyre's lowest point below z = 0 (negative: above it)");
    s.finish();
    try {
        const Eigen::VectorXd u = structure::blown_up(tyre.shape, tyre.rubbers(), tyre.pressure);
        const structure::Solid about_axle = solid_of(tyre);
        tyre.axle.z() = -*draft - structure::WetSurface(about_axle, "outside", u).closed().bounds().min.z();
        const structure::Solid solid = solid_of(tyre);
        dofs_of(tyre, solid).basis();
        b.surface = structure::WetSurface(solid, "outside", u).closed();
    } catch (const InputError& e) { s.fail("elastic", e.what()); } catch (const RunError& e) {
        s.fail("pressure", fmt::format("bursts the tyre: {}", e.what()));
    }
    if (const double least = least_contact_depth(tyre, steps_of(tyre, solid_of(tyre))); tyre.contact_depth < least)
        s.fail("contact_depth",
               fmt::format("so stiff a floor cuts time into steps more than ten times finer than the rubber needs; "
                           "expected at least {:.2g} m",
                           1.1 * least));
    RigidBodySetup& m = b.motion;
    const RigidMass uniform = solid_mass(b.surface, 1);
    m.mass.mass = tyre.total_mass;
    m.mass.centre = tyre.axle;
    m.mass.inertia = m.mass.mass / uniform.mass * uniform.inertia;
    m.velocity = tyre.velocity;
    for (std::size_t a = 0; a < 3; ++a) {
        m.free.along[a] = !tyre.locked[a];
        m.free.about[a] = false;
    }
    b.elastic = std::move(tyre);
}

}  // namespace tw

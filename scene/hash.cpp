#include "scene/hash.h"

#include <fmt/format.h>

#include <charconv>
#include <stdexcept>

#include "base/sha256.h"
#include "methods/methods.h"
#include "methods/names.h"
#include "scene/effects/registry.h"
#include "scene/keys/keys.h"
#include "scene/mesh/edge_refinement.h"

namespace tw {
namespace {

class Lines {
public:
    Lines& add(const std::string& name, std::initializer_list<double> values) {
        text_ += name;
        for (const double v : values) {
            char digits[32];
            const auto end = std::to_chars(digits, digits + sizeof digits, v == 0 ? 0.0 : v).ptr;  // no minus zero
            text_ += ' ';
            text_.append(digits, end);
        }
        text_ += '\n';
        return *this;
    }
    Lines& add(const std::string& name, const std::string& word) {
        text_ += name + ' ' + word + '\n';
        return *this;
    }
    Lines& add(const std::string& name, const Vec3& v) { return add(name, {v.x(), v.y(), v.z()}); }
    Lines& add(const std::string& name, const Box& box) {
        return add(name + ".min", box.min).add(name + ".max", box.max);
    }
    const std::string& text() const { return text_; }

private:
    std::string text_;
};

/// A value as a line, or as several of one name.
template <class Value>
void add_value(Lines& t, const std::string& name, const Value& value) {
    if constexpr (std::is_arithmetic_v<Value>)
        t.add(name, {static_cast<double>(value)});
    else if constexpr (std::is_same_v<Value, std::string>)
        t.add(name, value);
    else if constexpr (std::is_same_v<Value, std::vector<double>>)
        for (const double v : value) t.add(name, {v});
    else
        throw std::logic_error(name + ": lists of words are not hashed");
}

bool is_default(const SceneKey& key, Scene& scene, std::size_t k) {
    bool same = false;
    with_value(key, scene, k, [&](const auto& value) {
        Scene fresh = unsaid(key);
        with_value(key, fresh, 0, [&](const auto& other) {
            if constexpr (std::is_same_v<decltype(other), decltype(value)>) same = other == value;
        });
    });
    return same;
}

/// The keys of the table that the scene's hash covers, or that a method's own does, with their values; those of a
/// repeated section with the number of the entry. What belongs to an effect counts while it is on.
void add_keys(Lines& t, const Scene& scene, SceneKey::Hashed hashed, const std::string& method = {}) {
    Scene& readable = const_cast<Scene&>(scene);  // slots refer to a value; none is changed here
    for (const SceneKey& key : scene_keys()) {
        const bool of_other = !method.empty() && find_method(key.section) && key.section != method;
        if (key.hashed != hashed || of_other) continue;
        if (!key.effect.empty() && !scene.effect_on(key.effect)) continue;
        const bool repeated = static_cast<bool>(key.slot.entries);
        for (std::size_t k = 0; k < (repeated ? key.slot.entries(scene) : 1); ++k) {
            if (key.later && is_default(key, readable, k)) continue;
            const std::string entry = repeated ? fmt::format(".{}", k + 1) : "";
            with_value(key, readable, k,
                       [&](const auto& value) { add_value(t, key.section + entry + "." + key.name, value); });
        }
    }
}

/// In two dimensions the thickness is a particle's: two planes in its place.
Vec3 flattened(Vec3 p, double middle) {
    p.y() = p.y() > middle ? 1 : 0;
    return p;
}

/// Skin and margin follow from the particles' size unless they are written, so a family of sizes does not count them.
void add_plate(Lines& t, const ElasticPlate& plate, bool sizes) {
    t.add("plate", {plate.length, plate.breadth, double(plate.cells[0]), double(plate.cells[1]), plate.trim,
                    double(plate.large_rotations), plate.damping, plate.largest_step})
        .add("middle", plate.middle)
        .add("supports", plate.supports());
    if (plate.mesh) {
        for (const Vec3& x : plate.mesh->nodes) t.add("node", x);
        for (const auto& q : plate.mesh->quads) t.add("quad", {double(q[0]), double(q[1]), double(q[2]), double(q[3])});
        for (const auto* names : {&plate.clamped, &plate.hinged, &plate.carried})
            for (const std::string& name : *names)
                for (const int n : plate.mesh->sets.at(name)) t.add("supported", {double(n)});
    }
    if (plate.coupling_iterations > 1) t.add("coupling_iterations", {double(plate.coupling_iterations)});
    if (plate.coupling != "pressure") t.add("coupling", plate.coupling);
    if (plate.coupling == "penalty") t.add("contact", plate.contact).add("contact_factor", {plate.contact_factor});
    if (sizes) t.add("skin", {plate.skin, plate.margin});
    for (const structure::Ply& p : plate.plies) {
        const structure::PlyMaterial& m = p.material;
        t.add("ply", {p.angle, p.thickness, m.E1, m.E2, m.nu12, m.G12, m.G13, m.G23, m.density});
    }
    for (const ElasticGauge& g : plate.gauges)
        t.add("gauge", g.name)
            .add("at", g.position)
            .add("along", g.direction.value_or(Vec3::Zero()))
            .add("top", {double(g.top)});
}

void add_tyre(Lines& t, const ElasticTyre& tyre) {
    const structure::Tyre& s = tyre.shape;
    t.add("tyre", {s.outer_diameter, s.rim_diameter, s.width, s.tread_thickness, s.side_thickness, s.inner_thickness,
                   double(s.around), double(s.across), double(s.through_rubber)})
        .add("axle", tyre.axle)
        .add("inside", {tyre.pressure, tyre.damping, tyre.largest_step, tyre.contact_depth})
        .add("locked", {double(tyre.locked[0]), double(tyre.locked[1]), double(tyre.locked[2])});
    for (const structure::Hyperelastic& m : tyre.rubber) t.add("rubber", {m.C10, m.C01, m.bulk, m.density});
    for (const ElasticGauge& g : tyre.gauges) t.add("gauge", g.name).add("at", g.position);
}

void add_law(Lines& t, const MotionLaw& law) {
    t.add("law",
          {static_cast<double>(law.kind), double(law.turns), law.rate, law.ramp, law.amplitude, law.period, law.phase})
        .add("axis", law.axis);
    for (std::size_t k = 0; k < law.times.size(); ++k) t.add("row", {law.times[k], law.values[k]});
}

void add_body(Lines& t, const MovingBody& body, bool sizes) {
    const RigidBodySetup& m = body.motion;
    t.add("name", body.name);  // names are those of the record's tables and columns
    if (body.elastic) {
        t.add("mass", {m.mass.mass}).add("velocity", m.velocity);
        if (const ElasticTyre* tyre = body.tyre()) return add_tyre(t, *tyre);
        for (const bool locked : body.plate()->locked) t.add("locked", {double(locked)});
        return add_plate(t, *body.plate(), sizes);
    }
    t.add("body", surface_hash(body.surface)).add("mass", {m.mass.mass}).add("centre", m.mass.centre);
    for (int a = 0; a < 3; ++a) t.add("inertia", Vec3(m.mass.inertia.col(a)));
    for (const auto& free : {m.free.along, m.free.about})
        t.add("free", {double(free[0]), double(free[1]), double(free[2])});
    t.add("velocity", m.velocity).add("spin", m.spin);
    if (m.law) add_law(t, *m.law);
}

void add_free_hull(Lines& t, const FreeHull& free) {
    const RigidBodySetup& m = free.motion;
    t.add("free", {double(m.free.along[2]), double(m.free.about[1])})
        .add("mass", {m.mass.mass, m.mass.inertia(1, 1)})
        .add("centre", m.mass.centre);
}

/// What a run is made from besides the keys that stand in the scene as they are written. `sizes`: with the resolution
/// and what follows from it.
void add_geometry(Lines& t, const Scene& scene, bool sizes) {
    const Domain& d = scene.domain;
    t.add("motion", {static_cast<double>(scene.motion.kind)});
    t.add("domain", sizes ? d.box : d.as_asked).add("dimensions", {static_cast<double>(d.dimensions)});
    for (const Side side : {d.x_min, d.x_max, d.y_min, d.y_max, d.z_min, d.z_max})
        t.add("side", {static_cast<double>(side)});
    if (scene.hull) t.add("hull", scene.hull->hash).add("half", {scene.hull->half ? 1.0 : 0.0});
    if (scene.hull_is_free()) add_free_hull(t, *scene.hull->free);
    const bool flat = d.dimensions == 2 && !sizes;
    const double middle = 0.5 * (d.box.min.y() + d.box.max.y());
    for (const Obstacle& o : scene.obstacles) {
        Surface surface = o.surface;
        if (flat)
            for (Vec3& p : surface.points) p = flattened(p, middle);
        t.add("obstacle", surface_hash(surface));
        const auto number = &o - scene.obstacles.data() + 1;  // without a name of its own the hash is as ever
        if (o.name != fmt::format("obstacle{}", number)) t.add("name", o.name);
    }
    for (const MovingBody& body : scene.bodies) add_body(t, body, sizes);
    if (scene.tank_motion) {
        t.add("tank_pivot", scene.tank_motion->pivot);
        add_law(t, scene.tank_motion->law);
    }
    for (const Box& block : scene.water_blocks)
        t.add("block", flat ? Box{flattened(block.min, middle), flattened(block.max, middle)} : block);
    for (const PressureProbe& p : scene.sampling.pressure) t.add("pressure", p.name).add("at", p.place);
    for (const HeightProbe& p : scene.sampling.height) t.add("height", p.name).add("at", {p.x, p.y});
    for (const WaterBox& v : scene.sampling.volumes) t.add("volume", v.name).add("in", v.box);
    for (const RefinedPlace& place : scene.refined) {
        if (place.around == RefinedPlace::Around::box)
            t.add("refined", place.boxes.front());
        else
            t.add("refined_around",
                  {static_cast<double>(place.around), place.width.value_or(0), place.length.value_or(0)});
        t.add("halvings_short", {static_cast<double>(place.halvings_short)});
    }
    for (const EffectChoice& e : scene.effects) {  // off, under the name that it had when the first records were made
        const std::string& older = effect_part(e.name).older;
        t.add("effect." + (e.on || older.empty() ? e.name : older), {e.on ? 1.0 : 0.0});
    }
    if (!scene.wave_twin_of.empty()) t.add(scene.wave ? "bodies" : "wave", "left out");
    const RasterSpec& raster = scene.sampling.raster;
    if (sizes) {
        for (const auto& [method, hash] : scene.wave_twin_of) t.add("wave_twin_of." + method, hash);
        t.add("depth", {scene.water.depth}).add("resolution", {scene.resolution.spacing, scene.resolution.near_hull});
        for (const RefinementBox& r : scene.refinement)
            t.add("refine", r.box).add("level", {static_cast<double>(r.level)});
        t.add("raster", raster.origin);
        for (const int n : raster.count) t.add("count", {static_cast<double>(n)});
    }
    if (sizes || raster.chosen) t.add("voxel", {raster.voxel});
}

std::string text_of(const Scene& scene, bool sizes) {
    Lines t;
    t.add("format", {2});
    add_keys(t, scene, SceneKey::Hashed::scene);
    add_geometry(t, scene, sizes);
    return t.text();
}

std::string numerics_of(const Scene& scene, const std::string& method) {
    Lines t;
    add_keys(t, scene, SceneKey::Hashed::run, method);
    // how a run begins
    if (scene.motion.kind == Motion::Kind::stream) t.add("ramp", {scene.motion.ramp});
    if (scene.hull_is_free()) t.add("release", {scene.hull->free->motion.release});
    if (method == fvm_method)
        if (const EdgeRefinement shedding = edge_refinement(scene); !shedding.edges.empty())
            t.add("edge_halvings", {static_cast<double>(shedding.halvings)});
    return t.text();
}

}  // namespace

std::string canonical_text(const Scene& scene) { return text_of(scene, true); }

std::string scene_hash(const Scene& scene) { return sha256_hex(canonical_text(scene)); }

std::string run_hash(const Scene& scene, const std::string& method) {
    return sha256_hex(canonical_text(scene) + numerics_of(scene, method));
}

std::string family_hash(const Scene& scene, const std::string& method) {
    Scene member = scene;
    member.sph.levels = SphOptions{}.levels;  // how many sizes lie between near_hull and spacing follows from them
    return sha256_hex("family\n" + text_of(member, false) + numerics_of(member, method));
}

}  // namespace tw

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/errors.h"
#include "meshes/mass_properties.h"
#include "meshes/surface.h"
#include "scene/read/read.h"
#include "structure/degrees_of_freedom.h"
#include "structure/material.h"
#include "structure/read_mesh.h"
#include "structure/shell/gauge.h"
#include "structure/shell/skin.h"

namespace tw {
namespace {
using Materials = std::vector<std::pair<std::string, structure::Ply>>;

/// Every ply by its name, with material and thickness.
Materials read_plies(std::vector<SceneSection>& sections) {
    Materials materials;
    for (SceneSection& s : sections) {
        const auto needed = [&](const char* key) {
            const auto value = s.number(key);
            if (!value) s.fail(key, "missing; a ply needs it");
            return *value;
        };
        if (!s.has("name")) s.fail("name", "missing; layups name their plies");
        const std::string name = s.identifier("name", "ply");
        structure::Ply ply;
        ply.thickness = needed("thickness");
        structure::PlyMaterial& m = ply.material;
        m.E1 = needed("E1"), m.E2 = needed("E2"), m.nu12 = needed("nu12"), m.G12 = needed("G12");
        m.G13 = s.number("G13", m.G12), m.G23 = s.number("G23", m.G12);
        m.density = needed("density");
        if (const std::string why = structure::impossible(m); !why.empty())
            s.fail("E1", fmt::format("no material has the constants of ply {}: {}", name, why));
        for (const auto& [other, known] : materials)
            if (other == name)
                s.fail("name", fmt::format("ply {} is there already; give every ply its own name", name));
        materials.emplace_back(name, ply);
        s.finish();
    }
    return materials;
}

std::vector<structure::Ply> read_section(SceneSection& s, const Materials& materials) {
    const auto layup = s.text("layup");
    if (layup) {
        for (const char* of_isotropic : {"youngs_modulus", "poisson", "thickness", "density"})
            if (s.has(of_isotropic)) s.fail(of_isotropic, "stands beside layup, whose plies have their own; keep one");
        try {
            return structure::read_layup(*layup, materials);
        } catch (const InputError& e) { s.fail("layup", fmt::format("{}; plies are the [[ply]] sections", e.what())); }
    }
    const auto E = s.number("youngs_modulus"), nu = s.number("poisson"), t = s.number("thickness"),
               rho = s.number("density");
    for (const auto& [key, value] :
         {std::pair{"youngs_modulus", E}, {"poisson", nu}, {"thickness", t}, {"density", rho}})
        if (!value)
            s.fail(key, "missing; an elastic plate needs its layup, or youngs_modulus, poisson, thickness and density");
    const structure::PlyMaterial material = structure::isotropic(*E, *nu, *rho);
    if (const std::string why = structure::impossible(material); !why.empty())
        s.fail("poisson", "no material has these constants: " + why);
    return {{material, 0, *t}};
}

void read_rectangle(SceneSection& s, int dimensions, ElasticPlate& plate) {
    const auto size = s.numbers("plate");
    const auto cells = s.numbers("cells");
    if (!size) s.fail("plate", "missing; an elastic plate needs its length and breadth, or a mesh");
    if (!cells) s.fail("cells", "missing; an elastic plate needs its number of elements along and across");
    if (!((*size)[0] > 0 && (*size)[1] > 0)) s.fail("plate", "has no area; expected [length, breadth] above zero");
    plate.length = (*size)[0], plate.breadth = dimensions == 2 ? 0 : (*size)[1];
    for (std::size_t k = 0; k < 2; ++k) {
        plate.cells[k] = static_cast<int>((*cells)[k]);
        if (plate.cells[k] != (*cells)[k] || plate.cells[k] < 1 || plate.cells[k] > 1000)
            s.fail("cells", fmt::format("{} elements; expected whole numbers from 1 to 1000", (*cells)[k]));
    }
}

void read_shell_mesh(SceneSection& s, int dimensions, ElasticPlate& plate) {
    const std::string name = s.text("mesh", ""), unit = s.choice("unit").value_or("m");
    for (const char* of_rectangle : {"plate", "cells"})
        if (s.has(of_rectangle)) s.fail(of_rectangle, "stands beside mesh, which says where the plate lies; keep one");
    if (dimensions == 2) s.fail("mesh", "meshes are of three dimensions; expected plate and cells");
    const std::filesystem::path path =
        s.from_option("mesh") ? std::filesystem::path(name) : s.file().parent_path() / name;
    try {
        structure::MeshFile file = structure::read_mesh(path, metres_per(unit));
        if (file.shell.quads.empty())
            s.fail("mesh", path.string() + " holds hexahedra alone; expected the quadrilaterals of a mid-surface");
        Vec3 low = file.shell.nodes.front(), high = low;
        for (const Vec3& x : file.shell.nodes) low = low.cwiseMin(x), high = high.cwiseMax(x);
        plate.length = high.x() - low.x(), plate.breadth = high.y() - low.y();
        plate.mesh = std::make_shared<const structure::ShellMesh>(std::move(file.shell));
    } catch (const InputError& e) {
        if (std::string(e.what()).starts_with(s.file().string() + ":")) throw;
        s.fail("mesh", e.what());
    }
}

/// Names the edges of a rectangle, or node sets of a mesh.
void check_edge(SceneSection& s, const char* key, const std::string& edge, const ElasticPlate& plate) {
    static constexpr const char* edges[] = {"x_min", "x_max", "y_min", "y_max"};
    if (!plate.mesh) {
        if (std::ranges::find(edges, edge) == std::end(edges))
            s.fail(key, fmt::format("'{}' is not known; expected a list of: {}", edge, fmt::join(edges, ", ")));
        return;
    }
    if (plate.mesh->sets.contains(edge)) return;
    std::vector<std::string> known;
    for (const auto& [name, nodes] : plate.mesh->sets) known.push_back(name);
    s.fail(key, fmt::format("'{}' is no node set of the mesh; it has: {}", edge,
                            known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", "))));
}

void read_supports(SceneSection& s, ElasticPlate& plate) {
    for (const auto& [key, edges] :
         {std::pair{"clamped", &plate.clamped}, {"hinged", &plate.hinged}, {"carried", &plate.carried}}) {
        *edges = s.choices(key).value_or(std::vector<std::string>{});
        for (const std::string& edge : *edges) check_edge(s, key, edge, plate);
    }
    for (const auto* edges : {&plate.clamped, &plate.hinged, &plate.carried})
        for (const std::string& edge : *edges) {
            const auto times = [&](const std::vector<std::string>& of) { return std::ranges::count(of, edge); };
            if (times(plate.clamped) + times(plate.hinged) + times(plate.carried) > 1)
                s.fail("clamped", fmt::format("edge {} is supported twice; name it once", edge));
            if (plate.two_dimensional() && edge[0] == 'y')
                s.fail("clamped", fmt::format("{}: a strip of two dimensions has the edges x_min and x_max", edge));
        }
    const auto mass = s.number("mass");
    if (plate.carried.empty() != !mass)
        s.fail("mass", plate.carried.empty()
                           ? "is that of a plate and the frame that carries it: name its edges in carried"
                           : "missing; a carried plate needs the mass of plate and frame together");
    plate.total_mass = mass.value_or(0);
    if (plate.clamped.empty() && plate.hinged.empty() && plate.carried.empty() && !s.has("velocity"))
        s.fail("clamped",
               "the plate has neither support nor frame nor velocity; name edges in clamped, hinged or "
               "carried, or say with velocity that it flies");
}

}  // namespace

std::vector<std::optional<ElasticPart>> read_elastic(std::vector<SceneSection>& bodies,
                                                     std::vector<SceneSection>& plies,
                                                     std::vector<SceneSection>& gauges, int dimensions,
                                                     double gravity) {
    const Materials materials = read_plies(plies);
    std::vector<std::optional<ElasticPart>> parts(bodies.size());
    std::vector<std::size_t> elastic;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        SceneSection& s = bodies[b];
        const auto kind = s.choice("elastic");
        if (!kind) continue;
        elastic.push_back(b);
        if (*kind == "tyre") {
            parts[b] = read_tyre(s, dimensions, gravity);
            continue;
        }
        ElasticPlate& plate = std::get<ElasticPlate>(parts[b].emplace());
        if (s.has("mesh"))
            read_shell_mesh(s, dimensions, plate);
        else
            read_rectangle(s, dimensions, plate);
        plate.plies = read_section(s, materials);
        plate.middle = s.vector("middle").value_or(Vec3::Zero());
        if (dimensions == 2 && plate.middle.y() != 0)
            s.fail("middle", "leaves the plane y = 0 of two dimensions; expected [x, 0, z]");
        plate.trim = s.number("trim", 0.0);
        plate.velocity = s.vector("velocity").value_or(Vec3::Zero());
        read_supports(s, plate);
        plate.skin = s.number("skin", 0.0);
        plate.margin = s.number("margin", -1.0);
        plate.large_rotations = s.choice("rotations").value_or("large") == "large";
        plate.coupling = s.choice("coupling").value_or(plate.coupling);
        plate.contact = s.choice("contact").value_or(plate.contact);
        plate.contact_factor = s.number("contact_factor", plate.contact_factor);
        for (const char* key : {"contact", "contact_factor"})
            if (s.has(key) && plate.coupling != "penalty")
                s.fail(key, "belongs to coupling = \"penalty\"; leave it out, or write that");
        if (plate.coupling == "background" && dimensions == 2)
            s.fail("coupling", "nodes stand beside the plane of two dimensions; expected \"pressure\" or \"penalty\"");
        plate.damping = s.number("damping", 0.0);
        plate.largest_step = s.number("structure_step", 0.0);
        plate.coupling_iterations = s.whole("coupling_iterations").value_or(plate.coupling_iterations);
    }
    for (std::size_t g = 0; g < gauges.size(); ++g) {
        SceneSection& s = gauges[g];
        ElasticGauge gauge;
        gauge.name = s.identifier("name", fmt::format("gauge{}", g + 1));
        const std::string body = s.text("body", "");
        const auto of = std::ranges::find_if(elastic, [&](std::size_t b) {
            return body.empty() ? elastic.size() == 1 : bodies[b].text("name", fmt::format("body{}", b + 1)) == body;
        });
        if (of == elastic.end()) s.fail("body", fmt::format("'{}' is no elastic body of this scene", body));
        const auto at = s.vector("position");
        if (!at) s.fail("position", "missing; a gauge lies somewhere on its plate");
        gauge.position = *at;
        gauge.direction = s.vector("direction");
        gauge.top = s.choice("face").value_or("top") == "top";
        s.finish();
        std::visit([&](auto& part) { part.gauges.push_back(gauge); }, *parts[*of]);
    }
    return parts;
}

void read_plate_body(SceneSection& s, MovingBody& b, ElasticPlate plate) {
    static constexpr const char* names[] = {"surge", "sway", "heave", "roll", "pitch", "yaw"};
    for (const std::string& word : s.choices("locked").value_or(std::vector<std::string>{})) {
        if (plate.carried.empty()) s.fail("locked", "is for a frame; name the edges that it carries in carried");
        plate.locked[static_cast<std::size_t>(std::ranges::find(names, word) - std::begin(names))] = true;
    }
    b.source = fmt::format("elastic plate of {:.4g} mm", 1000 * plate.thickness());
    b.elastic = std::move(plate);
    s.finish();
}

void stand_elastic(MovingBody& body, double dp, SceneSection& s) {
    ElasticPlate& plate = std::get<ElasticPlate>(*body.elastic);
    const double thickness = plate.thickness();
    if (plate.skin == 0) plate.skin = std::max(thickness, 6 * dp);
    if (plate.margin < 0) plate.margin = plate.mesh ? 0 : 4 * dp;
    const double size = std::max({plate.length, plate.breadth, 16 * dp});
    if (plate.margin > size)
        s.fail("margin", fmt::format("goes on for more than the plate's own size; expected at most {:.3g} m, and water "
                                     "sees no farther than the default, 4 near_hull = {:.3g} m",
                                     size, 4 * dp));
    if (plate.skin > size)
        s.fail("skin", fmt::format("is thicker than the plate is long; expected at most {:.3g} m", size));
    if (plate.skin < thickness)
        s.fail("skin", fmt::format("is thinner than the plate, {:.4g} m; expected no less", thickness));
    try {
        // what is reported of two dimensions is per metre of span
        const structure::Shell shell = shell_of(plate, 1);
        dofs_of(plate, shell, 1).basis();
        for (const ElasticGauge& g : plate.gauges)
            structure::GaugeReader(shell,
                                   {g.name, g.position, g.direction.value_or(plate.turned(Vec3::UnitX())), g.top});
        body.surface = structure::Skin(shell, plate.skin).reference();
        RigidBodySetup& m = body.motion;
        double own = 0;
        for (int n = 0; 6 * n < shell.dofs(); ++n) own += shell.mass()[6 * n];
        m.mass.mass = plate.total_mass > 0 ? plate.total_mass : own;
        const RigidMass uniform = solid_mass(body.surface, 1);
        m.mass.centre = plate.centre();
        m.mass.inertia = m.mass.mass / uniform.mass * uniform.inertia;
        m.velocity = plate.velocity;
        for (std::size_t a = 0; a < 3; ++a) {
            const bool flat = plate.two_dimensional();
            m.free.along[a] = !plate.locked[a] && !(flat && a == 1);
            m.free.about[a] = !plate.locked[a + 3] && !(flat && a != 1);
        }
        if (!plate.clamped.empty() || !plate.hinged.empty()) m.law = MotionLaw{};  // it stays
    } catch (const InputError& e) { s.fail("elastic", e.what()); }
    if (plate.cell() > 4 * dp)
        body.findings.push_back({Finding::Level::warning, "coarse_elements",
                                 fmt::format("elements of {:.3g} m, {:.2g} particle spacings: water of one element "
                                             "pushes as a whole; expected at most 4",
                                             plate.cell(), plate.cell() / dp),
                                 plate.centre()});
    if (plate.skin > thickness * 1.01)
        body.findings.push_back({Finding::Level::note, "thick_skin",
                                 fmt::format("the water sees a surface of {:.4g} m about the plate of {:.4g} m: its "
                                             "faces stand {:.4g} m further out than the plate's",
                                             plate.skin, thickness, (plate.skin - thickness) / 2),
                                 plate.centre()});
}

}  // namespace tw

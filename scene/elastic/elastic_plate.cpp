#include "scene/elastic/elastic_plate.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>

#include "base/errors.h"
#include "structure/degrees_of_freedom.h"
#include "structure/generate.h"
#include "structure/modes.h"
#include "structure/shell/shell.h"

namespace tw {
namespace {

bool has(const std::vector<std::string>& edges, const std::string& edge) {
    return std::ranges::find(edges, edge) != edges.end();
}

/// The mesh of the flat plate: cells between the edges, and more of the same beyond clamped ones.
struct Lattice {
    double x0, y0, dx, dy;
    int nx, ny;

    Lattice(const ElasticPlate& p, double width) {
        const auto along = [&](double size, int cells, const char* low, const char* high, double& from, double& step,
                               int& count) {
            step = size / cells;
            const int more = static_cast<int>(std::ceil(p.margin / step - 1e-9));
            from = -size / 2 - (has(p.clamped, low) ? more : 0) * step;
            count = cells + more * (has(p.clamped, low) + has(p.clamped, high));
        };
        along(p.length, p.cells[0], "x_min", "x_max", x0, dx, nx);
        if (p.two_dimensional())
            y0 = -width / 2, dy = width, ny = 1;
        else
            along(p.breadth, p.cells[1], "y_min", "y_max", y0, dy, ny);
    }
    /// Of a node, in the flat plate about its middle.
    Vec3 place(int node) const { return {x0 + dx * (node % (nx + 1)), y0 + dy * (node / (nx + 1)), 0}; }
};

/// Whether a place of the flat plate lies on or beyond one of these edges.
bool beyond(const ElasticPlate& p, const std::vector<std::string>& edges, const Vec3& x) {
    const double little = 1e-9 * p.length;
    return (has(edges, "x_min") && x.x() < -p.length / 2 + little) ||
           (has(edges, "x_max") && x.x() > p.length / 2 - little) ||
           (has(edges, "y_min") && x.y() < -p.breadth / 2 + little) ||
           (has(edges, "y_max") && x.y() > p.breadth / 2 - little);
}

/// Which nodes of the shell belong to these edges or, of a mesh, node sets.
std::vector<bool> supported(const ElasticPlate& p, const std::vector<std::string>& edges,
                            const structure::ShellMesh& mesh, double width) {
    std::vector<bool> of(mesh.nodes.size(), false);
    if (p.mesh) {
        for (const std::string& set : edges)
            for (const int n : mesh.sets.at(set)) of[static_cast<std::size_t>(n)] = true;
        return of;
    }
    const Lattice lattice(p, width);
    for (std::size_t n = 0; n < of.size(); ++n) of[n] = beyond(p, edges, lattice.place(static_cast<int>(n)));
    return of;
}

}  // namespace

double ElasticPlate::cell() const {
    if (mesh) {
        double longest = 0;
        for (const auto& quad : mesh->quads)
            for (std::size_t k = 0; k < 4; ++k)
                longest = std::max(longest, (mesh->nodes[static_cast<std::size_t>(quad[k])] -
                                             mesh->nodes[static_cast<std::size_t>(quad[(k + 1) % 4])])
                                                .norm());
        return longest;
    }
    const double along = length / cells[0];
    return two_dimensional() ? along : std::max(along, breadth / cells[1]);
}

int ElasticPlate::elements() const {
    if (mesh) return static_cast<int>(mesh->quads.size());
    return two_dimensional() ? cells[0] : cells[0] * cells[1];
}

Vec3 ElasticPlate::centre() const {
    if (!mesh) return middle;
    Vec3 low = mesh->nodes.front(), high = low;
    for (const Vec3& x : mesh->nodes) low = low.cwiseMin(x), high = high.cwiseMax(x);
    return placed((low + high) / 2);
}

/// Bow up: the low end of the plate's own x axis rises.
Vec3 ElasticPlate::turned(const Vec3& v) const { return Eigen::AngleAxisd(trim, Vec3::UnitY()) * v; }

std::string ElasticPlate::supports() const {
    std::string out;
    for (const auto& [how, edges] : {std::pair{"clamped", &clamped}, {"hinged", &hinged}, {"carried", &carried}})
        if (!edges->empty()) out += fmt::format("{}{} at {}", out.empty() ? "" : "; ", how, fmt::join(*edges, ", "));
    return out.empty() ? "free" : out;
}

double ElasticPlate::first_period() const {
    ElasticPlate held = *this;  // a frame's own motions strain nothing
    if (!carried.empty()) held.locked.fill(true);
    const structure::Shell shell = shell_of(held, strip());
    return structure::first_period(shell, dofs_of(held, shell, strip()));
}

structure::Shell shell_of(const ElasticPlate& plate, double width) {
    if (plate.mesh) {
        structure::ShellMesh mesh = *plate.mesh;
        for (Vec3& x : mesh.nodes) x = plate.placed(x);
        return structure::Shell(std::move(mesh), structure::Laminate(plate.plies), plate.turned(Vec3::UnitX()));
    }
    const Lattice lattice(plate, width);
    structure::ShellMesh mesh =
        structure::plate_mesh(lattice.nx * lattice.dx, lattice.ny * lattice.dy, lattice.nx, lattice.ny);
    for (int n = 0; n < static_cast<int>(mesh.nodes.size()); ++n)
        mesh.nodes[static_cast<std::size_t>(n)] = plate.placed(lattice.place(n));
    return structure::Shell(std::move(mesh), structure::Laminate(plate.plies), plate.turned(Vec3::UnitX()));
}

structure::DegreesOfFreedom dofs_of(const ElasticPlate& plate, const structure::Shell& shell, double width) {
    const structure::ShellMesh& mesh = shell.mesh();
    structure::DegreesOfFreedom dofs(mesh.nodes, 6);
    const std::vector<bool> clamped = supported(plate, plate.clamped, mesh, width),
                            carried = supported(plate, plate.carried, mesh, width),
                            hinged = supported(plate, plate.hinged, mesh, width);
    structure::RigidPart frame;
    double own = 0;
    for (int n = 0; n < static_cast<int>(mesh.nodes.size()); ++n) {
        const int node[] = {n};
        const auto k = static_cast<std::size_t>(n);
        own += shell.mass()[6 * n];
        if (clamped[k])
            dofs.clamp(node);
        else if (carried[k])
            frame.nodes.push_back(n);
        else if (hinged[k])
            dofs.hinge(node);
        if (plate.two_dimensional()) dofs.hold(node, {1, 3, 5});
    }
    if (frame.nodes.empty()) return dofs;
    frame.mass = width * plate.total_mass - own;
    if (!(frame.mass > 0))
        throw InputError(
            fmt::format("the plate alone has {:.4g} kg; expected a larger mass, that of plate and frame "
                        "together",
                        own / width));
    // a ring over the carried edges
    frame.centre = plate.centre();
    for (const int n : frame.nodes) {
        const Vec3 r = mesh.nodes[static_cast<std::size_t>(n)] - frame.centre;
        frame.inertia += frame.mass / static_cast<double>(frame.nodes.size()) *
                         (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
    }
    frame.held = plate.locked;
    if (plate.two_dimensional()) frame.held[1] = frame.held[3] = frame.held[5] = true;
    dofs.carry(std::move(frame));
    return dofs;
}

}  // namespace tw

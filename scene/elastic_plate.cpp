#include "scene/elastic_plate.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>

#include "base/errors.h"
#include "structure/freedoms.h"
#include "structure/generate.h"
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

}  // namespace

double ElasticPlate::cell() const {
    const double along = length / cells[0];
    return two_dimensional() ? along : std::max(along, breadth / cells[1]);
}

/// Bow up: the low end of the plate's own x axis rises.
Vec3 ElasticPlate::turned(const Vec3& v) const { return Eigen::AngleAxisd(trim, Vec3::UnitY()) * v; }

std::string ElasticPlate::supports() const {
    std::string out;
    for (const auto& [how, edges] : {std::pair{"clamped", &clamped}, {"hinged", &hinged}, {"carried", &carried}})
        if (!edges->empty()) out += fmt::format("{}{} at {}", out.empty() ? "" : "; ", how, fmt::join(*edges, ", "));
    return out.empty() ? "free" : out;
}

structure::Shell shell_of(const ElasticPlate& plate, double width) {
    const Lattice lattice(plate, width);
    structure::ShellMesh mesh =
        structure::plate_mesh(lattice.nx * lattice.dx, lattice.ny * lattice.dy, lattice.nx, lattice.ny);
    for (int n = 0; n < static_cast<int>(mesh.nodes.size()); ++n)
        mesh.nodes[static_cast<std::size_t>(n)] = plate.placed(lattice.place(n));
    return structure::Shell(std::move(mesh), structure::Laminate(plate.plies), plate.turned(Vec3::UnitX()));
}

structure::Freedoms freedoms_of(const ElasticPlate& plate, const structure::Shell& shell, double width) {
    const Lattice lattice(plate, width);
    structure::Freedoms freedoms(shell.mesh().nodes, 6);
    structure::RigidPart frame;
    double own = 0;
    for (int n = 0; n < static_cast<int>(shell.mesh().nodes.size()); ++n) {
        const int node[] = {n};
        const Vec3 x = lattice.place(n);
        own += shell.mass()[6 * n];
        if (beyond(plate, plate.clamped, x))
            freedoms.clamp(node);
        else if (beyond(plate, plate.carried, x))
            frame.nodes.push_back(n);
        else if (beyond(plate, plate.hinged, x))
            freedoms.hinge(node);
        if (plate.two_dimensional()) freedoms.hold(node, {1, 3, 5});
    }
    if (frame.nodes.empty()) return freedoms;
    frame.mass = width * plate.total_mass - own;
    if (!(frame.mass > 0))
        throw InputError(
            fmt::format("the plate alone has {:.4g} kg; expected a larger mass, that of plate and frame "
                        "together",
                        own / width));
    // a ring over the carried edges
    frame.centre = plate.middle;
    for (const int n : frame.nodes) {
        const Vec3 r = shell.mesh().nodes[static_cast<std::size_t>(n)] - frame.centre;
        frame.inertia += frame.mass / static_cast<double>(frame.nodes.size()) *
                         (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
    }
    frame.held = plate.locked;
    if (plate.two_dimensional()) frame.held[1] = frame.held[3] = frame.held[5] = true;
    freedoms.carry(std::move(frame));
    return freedoms;
}

}  // namespace tw

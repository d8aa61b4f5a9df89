#include "structure/tyre.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/errors.h"
#include "structure/generate.h"

namespace tw::structure {
namespace {

void refuse_impossible(const Tyre& t) {
    const double height = (t.outer_diameter - t.rim_diameter) / 2, thickest = t.tread_thickness + t.inner_thickness;
    if (!(t.rim_diameter > 0 && height > 2 * thickest && t.width > 4 * thickest && t.side_thickness > 0 &&
          t.tread_thickness >= t.side_thickness && t.inner_thickness > 0))
        throw InputError(
            "a tyre's rim is smaller than its outside, and its walls are thin beside its section and not "
            "thicker than its tread");
    if (!(t.bead_angle > std::numbers::pi / 2 && t.bead_angle < std::numbers::pi && t.tread_angle > 0 &&
          t.tread_angle < std::numbers::pi / 2 && t.around >= 8 && t.across >= 8 && t.through_rubber >= 1))
        throw InputError(
            "a tyre's wall turns in by more than a quarter of a circle, less than half; its tread ends before "
            "a quarter; it takes 8 cells or more around and across");
}

/// `cells` of t.around, the first at the angle `from`.
SolidMesh cut_mesh(const Tyre& t, int cells, double from) {
    refuse_impossible(t);
    const double a = t.width / 2, b = (t.outer_diameter - t.rim_diameter) / 2 / (1 - std::cos(t.bead_angle)),
                 middle = t.outer_diameter / 2 - b, arc = 2 * std::numbers::pi * cells / t.around;
    const int layers = t.through_rubber + 1;
    const auto place = [&](const Vec3& p) {
        const double theta = from - arc * p.x(), phi = (2 * p.y() - 1) * t.bead_angle;
        // From the tread's thickness to the side wall's over 0.16 rad about the tread's end.
        const double s = std::clamp((std::abs(phi) - t.tread_angle) / 0.16 + 0.5, 0.0, 1.0);
        const double rubber = t.tread_thickness + (t.side_thickness - t.tread_thickness) * s * s * (3 - 2 * s);
        const double layer = p.z() * layers;  // 0 to 1 is the inner tyre
        const double depth =
            layer <= 1 ? rubber + t.inner_thickness * (1 - layer) : rubber * (layers - layer) / t.through_rubber;
        const Eigen::Vector2d outside(a * std::sin(phi), middle + b * std::cos(phi));  // axial, radial
        const Eigen::Vector2d normal = Eigen::Vector2d(b * std::sin(phi), a * std::cos(phi)).normalized();
        const Eigen::Vector2d q = outside - depth * normal;
        return Vec3(q[1] * std::cos(theta), q[0], q[1] * std::sin(theta));
    };
    SolidMesh m = block_mesh({cells, t.across, layers}, place, cells == t.around);
    std::size_t e = 0;
    for (int k = 0; k < layers; ++k)
        for (int j = 0; j < t.across; ++j)
            for (int i = 0; i < cells; ++i) {
                const double phi = ((2.0 * j + 1) / t.across - 1) * t.bead_angle;
                m.material[e++] = k == 0 ? 0 : std::abs(phi) < t.tread_angle ? 2 : 1;
            }
    auto& rim = m.sets["rim"];
    for (const char* bead : {"y_min", "y_max"}) rim.insert(rim.end(), m.sets[bead].begin(), m.sets[bead].end());
    m.surfaces["inside"] = m.surfaces["z_min"];
    m.surfaces["outside"] = m.surfaces["z_max"];
    for (const char* name : {"y_min", "y_max", "z_min", "z_max"}) {
        m.sets.erase(name);
        m.surfaces.erase(name);
    }
    return m;
}
}  // namespace

SolidMesh tyre_mesh(const Tyre& t) { return cut_mesh(t, t.around, 0); }

SolidMesh tyre_sector(const Tyre& t, int cells, double from) {
    SolidMesh m = cut_mesh(t, cells, from);
    m.sets["begin"] = m.sets.at("x_min");
    m.sets["end"] = m.sets.at("x_max");
    return m;
}

}  // namespace tw::structure

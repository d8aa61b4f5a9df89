#include <fmt/format.h>

#include <cmath>
#include <locale>
#include <sstream>

#include "base/errors.h"
#include "import/readers.h"

namespace tw {
namespace {

Vec3 reference_of(const RunRecord& record) {
    const auto found = record.attributes.find("moment_reference");
    std::istringstream text(found == record.attributes.end() ? "" : found->second);
    text.imbue(std::locale::classic());
    Vec3 r;
    if (text >> r.x() >> r.y() >> r.z() && r.allFinite()) return r;
    return Vec3::Zero();
}

}  // namespace

/// About another point the same loads have M_y' = M_y + d_z F_x - d_x F_z, with d from the new point to the old.
void refer_moment(const Mapping& mapping, const MomentPoint& point, RunRecord& record) {
    if (!record.series("forces", "my")) return;
    const Vec3 reference = reference_of(record);
    if (!point)
        throw InputError(
            fmt::format("{}: nothing says which point the moment my is taken about; add e.g. moment_point = "
                        "[{:.6g}, {:.6g}, {:.6g}], the scene's own, or where it was measured, in metres",
                        mapping.file.string(), reference.x(), reference.y(), reference.z()));
    const Vec3 d = *point - reference;
    const Column *fx = record.series("forces", "fx"), *fz = record.series("forces", "fz");
    if ((d.z() != 0 && !fx) || (d.x() != 0 && !fz))
        throw InputError(
            fmt::format("{}: my is about ({:.6g}, {:.6g}, {:.6g}) m, the scene's moments about ({:.6g}, "
                        "{:.6g}, {:.6g}) m; expected {} beside it, to move it there",
                        mapping.file.string(), point->x(), point->y(), point->z(), reference.x(), reference.y(),
                        reference.z(), d.z() != 0 && !fx ? "fx" : "fz"));
    std::vector<double> moved = record.series("forces", "my")->values;
    for (std::size_t i = 0; i < moved.size(); ++i) {
        if (d.z() != 0) moved[i] += d.z() * fx->values[i];
        if (d.x() != 0) moved[i] -= d.x() * fz->values[i];
    }
    record.table("forces").column("my", "N m").values = std::move(moved);
}

/// The other half carries the same fx, fz and my, and the opposite fy. Lengths, pressures and heights are of the whole
/// already.
void make_whole(RunRecord& record) {
    for (auto& [table_name, table] : record.tables)
        for (Column& c : table.columns) {
            const bool side = c.name == "fy";
            if (table_name != "forces" && c.name != "wetted_area") continue;
            for (double& v : c.values) v = side && std::isfinite(v) ? 0.0 : 2 * v;
        }
}

}  // namespace tw

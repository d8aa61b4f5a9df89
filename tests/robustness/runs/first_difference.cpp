#include "first_difference.h"

#include <cstring>

namespace tw::test {
namespace {

bool same(const std::vector<double>& u, const std::vector<double>& v) {
    return u.size() == v.size() && (u.empty() || std::memcmp(u.data(), v.data(), u.size() * sizeof(double)) == 0);
}

}  // namespace

std::string first_difference(const RunRecord& a, const RunRecord& b) {
    if (a.tables.size() != b.tables.size()) return "number of tables";
    for (const auto& [name, table] : a.tables) {
        const auto other = b.tables.find(name);
        if (other == b.tables.end()) return name + " is in one only";
        if (!same(table.time, other->second.time)) return name + ".time";
        if (table.columns.size() != other->second.columns.size()) return name + ": number of columns";
        for (const Column& column : table.columns) {
            const Column* of_b = other->second.find(column.name);
            if (!of_b || !same(column.values, of_b->values)) return name + "." + column.name;
        }
    }
    if (a.frames.size() != b.frames.size()) return "number of raster frames";
    for (std::size_t i = 0; i < a.frames.size(); ++i)
        if (a.frames[i].water != b.frames[i].water) return "raster frame " + std::to_string(i);
    if (a.hull.points != b.hull.points || a.hull.triangles != b.hull.triangles) return "the hull's surface";
    if (a.hull_pressure != b.hull_pressure || a.hull_wet != b.hull_wet) return "the hull's pressure";
    for (const auto& [name, text] : a.attributes)
        if (!b.attributes.contains(name)) return "attribute " + name + " is in the first only";
    for (const auto& [name, value] : a.numbers)
        if (!b.numbers.contains(name)) return "number " + name + " is in the first only";
    if (a.steps != b.steps) return "steps";
    if (a.elements != b.elements) return "elements";
    return {};
}

}  // namespace tw::test

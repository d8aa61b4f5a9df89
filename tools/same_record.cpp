// Compares two run records bit by bit:
//
//   same_record OLD.h5 NEW.h5
//
// Prints one line, what was compared or the first difference, and ends with 0 (same), 1 (different) or 2 (a record that
// cannot be read). Numbers are the same when their bits are: NaN equals the same NaN, 0 differs from -0. What depends
// on the machine's load (wall time, memory) and what is text (provenance, reasons) is left out.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <optional>

#include "record/run_record.h"

namespace tw {
namespace {

/// Columns under one name; those of a raster frame and of the hull hold one value per voxel and per triangle.
struct Part {
    std::string name;
    std::vector<Column> columns;
};

template <class Values>
Column column_of(const std::string& name, const Values& values) {
    return {name, "", std::vector<double>(values.begin(), values.end())};
}

std::vector<Part> parts_of(const RunRecord& r) {
    std::vector<Part> parts;
    for (const auto& [name, table] : r.tables) {
        Part& part = parts.emplace_back(Part{name, {column_of("time", table.time)}});
        part.columns.insert(part.columns.end(), table.columns.begin(), table.columns.end());
    }
    Part raster{"raster", {{"time", "", {}}}};
    for (std::size_t k = 0; k < r.frames.size(); ++k) {
        raster.columns[0].values.push_back(r.frames[k].time);
        raster.columns.push_back(column_of(fmt::format("frame {}", k), r.frames[k].water));
    }
    parts.push_back(std::move(raster));
    parts.push_back({"hull", {column_of("pressure", r.hull_pressure), column_of("wet", r.hull_wet)}});
    Part validity_checks{"certificate", {}};
    for (const RecordedCheck& l : r.validity_checks)
        validity_checks.columns.push_back(
            {l.name, "", {l.value, l.limit, l.time, l.place.x(), l.place.y(), l.place.z()}});
    parts.push_back(std::move(validity_checks));
    parts.push_back({"size", {column_of("elements, steps", std::vector{r.elements, r.steps})}});
    return parts;
}

template <class Named>
const Named* named(const std::vector<Named>& list, const std::string& name) {
    const auto at = std::ranges::find(list, name, &Named::name);
    return at == list.end() ? nullptr : &*at;
}

/// The first name that only one of the two lists has.
template <class Named>
std::optional<std::string> lonely(const std::vector<Named>& a, const std::vector<Named>& b) {
    for (const Named& x : a)
        if (!named(b, x.name)) return x.name + " only in the old record";
    for (const Named& x : b)
        if (!named(a, x.name)) return x.name + " only in the new record";
    return {};
}

/// The earliest row in which two parts of one name differ.
std::optional<std::string> difference(const Part& a, const Part& b) {
    if (const auto name = lonely(a.columns, b.columns)) return fmt::format("table {}, column {}", a.name, *name);
    std::size_t earliest = SIZE_MAX;
    std::string found;
    for (const Column& x : a.columns) {
        const Column& y = *named(b.columns, x.name);
        const std::size_t rows = std::min(x.values.size(), y.values.size());
        std::size_t row = 0;
        while (row < rows && std::bit_cast<std::uint64_t>(x.values[row]) == std::bit_cast<std::uint64_t>(y.values[row]))
            ++row;
        if (row >= earliest || (row == rows && x.values.size() == y.values.size())) continue;
        earliest = row;
        found = row == rows ? fmt::format("table {}, column {}: {} rows and {}", a.name, x.name, x.values.size(),
                                          y.values.size())
                            : fmt::format("table {}, column {}, row {}: {} and {}", a.name, x.name, row, x.values[row],
                                          y.values[row]);
    }
    return found.empty() ? std::nullopt : std::optional(found);
}

std::optional<std::string> difference(const std::vector<Part>& a, const std::vector<Part>& b) {
    if (const auto name = lonely(a, b)) return "table " + *name;
    for (const Part& part : a)
        if (auto found = difference(part, *named(b, part.name))) return found;
    return {};
}

}  // namespace
}  // namespace tw

int main(int argc, char** argv) try {
    if (argc != 3) {
        std::fputs("usage: same_record OLD.h5 NEW.h5\n", stderr);
        return 2;
    }
    const tw::RunRecord before = tw::read_record(argv[1]), after = tw::read_record(argv[2]);
    if (const auto found = tw::difference(tw::parts_of(before), tw::parts_of(after))) {
        fmt::print("DIFFERENT ({})\n", *found);
        return 1;
    }
    std::size_t rows = 0;
    for (const auto& [name, table] : before.tables) rows += table.time.size();
    fmt::print("same ({} rows of {} tables, {} raster frames)\n", rows, before.tables.size(), before.frames.size());
    return 0;
} catch (const std::exception& e) {
    std::fputs((std::string(e.what()) + "\n").c_str(), stderr);
    return 2;
}

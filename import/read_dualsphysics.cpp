#include <fmt/format.h>

#include <algorithm>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "import/readers.h"
#include "text/csv_columns.h"

namespace tw {
namespace {

/// What ComputeForces writes (DualSPHysics 5; commas with -csvsep:1):
///
///   Part;Time [s];Np;ForceFluid.x [N];ForceFluid.y [N];ForceFluid.z [N];ForceFluid [N]
///
/// behind it ForceTotal.* when a gravity was given, Moment* columns about the axes that were asked for. Other names are
/// those of scripts round it. The first that the file has is taken.
struct KnownColumn {
    const char *table, *name, *unit;
    std::vector<std::string> stems;  ///< lower case, letters and digits of the header up to its unit
};
const KnownColumn known_time{"", "time", "s", {"time", "t", "times"}};
const std::vector<KnownColumn> known_forces{
    {"forces", "fx", "N", {"forcefluidx", "forcex", "fx"}},
    {"forces", "fy", "N", {"forcefluidy", "forcey", "fy"}},
    {"forces", "fz", "N", {"forcefluidz", "forcez", "fz"}},
};

/// "ForceFluid.x [N]" -> "forcefluidx".
std::string stem_of(const std::string& header) {
    std::string stem;
    for (const char c : header.substr(0, header.find_first_of("[("))) {
        if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) stem += c;
        if (c >= 'A' && c <= 'Z') stem += static_cast<char>(c - 'A' + 'a');
    }
    return stem;
}

std::optional<ColumnSource> found_column(const KnownColumn& known, const CsvColumns& csv, const std::string& place) {
    for (const std::string& stem : known.stems)
        for (std::size_t i = 0; i < csv.headers().size(); ++i) {
            if (stem_of(csv.headers()[i]) != stem) continue;
            ColumnSource c;
            c.table = known.table;
            c.name = known.name;
            c.si_unit = known.unit;
            c.number = static_cast<int>(i) + 1;
            if (csv.headers()[i].find_first_of("[(") == std::string::npos) c.unit = known.unit;  // it writes SI
            c.place = place;
            return c;
        }
    return {};
}

}  // namespace

MomentPoint read_dualsphysics(Mapping mapping, RunRecord& record) {
    const CsvColumns csv(read_text(mapping.source), mapping.source.string());
    const std::string place = mapping.place.at("source");
    if (!mapping.time) mapping.time = found_column(known_time, csv, place);
    for (const KnownColumn& known : known_forces)
        if (std::ranges::find_if(mapping.columns, [&](const ColumnSource& c) {
                return c.table == known.table && c.name == known.name;
            }) == mapping.columns.end())
            if (const auto c = found_column(known, csv, place)) mapping.columns.push_back(*c);
    if (!mapping.time || mapping.columns.empty())
        throw InputError(
            fmt::format("{}: {} is no ComputeForces CSV: its columns are {}; expected Time [s], "
                        "ForceFluid.x [N], ...; for other files use kind = \"csv\" and name the columns",
                        place, csv.file(), csv.header_list()));
    return read_csv(mapping, record);
}

}  // namespace tw

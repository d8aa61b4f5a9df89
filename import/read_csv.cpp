#include <fmt/format.h>

#include <cmath>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "import/logger_csv.h"
#include "import/readers.h"
#include "record/water_in_box.h"
#include "text/csv_columns.h"
#include "text/did_you_mean.h"
#include "text/units.h"

namespace tw {
namespace {

std::size_t column_of(const ColumnSource& c, const CsvColumns& csv) {
    const std::size_t count = csv.headers().size();
    if (c.header.empty()) {
        if (static_cast<std::size_t>(c.number) <= count) return static_cast<std::size_t>(c.number) - 1;
        throw InputError(fmt::format("{}: there is no column {}; {} has {}: {}", c.place, c.number, csv.file(), count,
                                     csv.header_list()));
    }
    const std::vector<std::size_t> found = csv.find(c.header);
    if (found.size() == 1) return found[0];
    if (found.empty())
        throw InputError(fmt::format("{}: there is no column {}; the columns of {} are: {}{}", c.place,
                                     shown_cell(c.header), csv.file(), csv.header_list(),
                                     did_you_mean(c.header, csv.headers())));
    throw InputError(fmt::format("{}: {} columns are named {}; expected one, or its number: {}, ...", c.place,
                                 found.size(), shown_cell(c.header), found[0] + 1));
}

/// The unit that a header ends in, as in "Lift [kN]" or "Physical Time (s)"; empty when it names none.
std::string unit_of_header(const std::string& header) {
    for (const auto& [open, close] : {std::pair{'[', ']'}, {'(', ')'}}) {
        const std::size_t from = header.rfind(open);
        if (!header.ends_with(close) || from == std::string::npos) continue;
        const std::string unit = header.substr(from + 1, header.size() - from - 2);
        if (unit == "Nm" || unit == "N-m") return "N m";  // as DualSPHysics and STAR-CCM+ write it
        try {
            parse_unit(unit);
            return unit;
        } catch (const UnitError&) { return {}; }
    }
    return {};
}

double factor_of(const ColumnSource& c, const std::string& header, const CsvColumns& csv, const std::string& below) {
    const std::string unit = !c.unit.empty() ? c.unit : !below.empty() ? below : unit_of_header(header);
    const std::string help = fmt::format("expected unit = \"{}\" or another of: {}", c.si_unit, units_like(c.si_unit));
    if (unit.empty())
        throw InputError(fmt::format("{}: neither the mapping nor the header {} of {} gives a unit; {}", c.place,
                                     shown_cell(header), csv.file(), help));
    const Unit parsed = [&] {
        try {
            return parse_unit(unit);
        } catch (const UnitError& e) {
            throw InputError(fmt::format("{}: column {} of {}: its unit {}; {}", c.place, shown_cell(header),
                                         csv.file(), e.what(), help));
        }
    }();
    if (parsed.dimension != parse_unit(c.si_unit).dimension)
        throw InputError(
            fmt::format("{}: column {} of {} is in {}; {}", c.place, shown_cell(header), csv.file(), unit, help));
    return c.scale * parsed.factor;
}

std::vector<double> times_of(const ColumnSource& c, const CsvColumns& csv, const std::vector<std::string>& units) {
    std::vector<double> time = series_of(c, csv, units);
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (!std::isfinite(time[i]))
            throw InputError(
                fmt::format("{}:{}: no time found; expected a number in every row", csv.file(), csv.line(i)));
        if (i > 0 && time[i] <= time[i - 1])
            throw InputError(fmt::format("{}:{}: time {:.9g} s found after {:.9g} s; expected times that increase",
                                         csv.file(), csv.line(i), time[i], time[i - 1]));
    }
    return time;
}

}  // namespace

std::vector<double> series_of(const ColumnSource& c, const CsvColumns& csv, const std::vector<std::string>& units) {
    const std::size_t column = column_of(c, csv);
    std::vector<double> series = csv.values(column);
    const double factor = factor_of(c, csv.headers()[column], csv, column < units.size() ? units[column] : "");
    for (double& v : series) v = factor * v + c.offset;
    return series;
}

MomentPoint read_csv(const Mapping& mapping, RunRecord& record) {
    const PlainCsv plain = plain_csv(read_text(mapping.source), mapping.source.string(), mapping.form);
    const CsvColumns csv(plain.text, mapping.source.string());
    std::vector<std::string> units = plain.units;
    const std::size_t clock = column_of(*mapping.time, csv);
    if (clock < plain.clock.size() && plain.clock[clock]) {  // seconds since the first row, whatever stands above them
        if (!mapping.time->unit.empty() && mapping.time->unit != "s")
            throw InputError(fmt::format("{}: the cells of {} are times of day, found unit {}; expected none, or s",
                                         mapping.time->place, shown_cell(csv.headers()[clock]), mapping.time->unit));
        units.resize(csv.headers().size());
        units[clock] = "s";
    }
    const std::vector<double> time = times_of(*mapping.time, csv, units);
    for (const ColumnSource& c : mapping.columns) {
        Table& table = record.table(c.table);
        table.time = time;
        const bool per_width = c.table == volume_table && record.numbers["dimensions"] == 2;
        table.column(c.name, per_width ? c.si_unit + "/m" : c.si_unit).values = series_of(c, csv, units);
    }
    return mapping.moment_point;
}

}  // namespace tw

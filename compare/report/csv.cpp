#include "compare/report/csv.h"

#include <fmt/format.h>

#include <cmath>

namespace tw {

namespace {

std::string number(double v) { return std::isfinite(v) ? fmt::format("{}", v) : ""; }

}  // namespace

std::string csv_cell(const std::string& text) {
    const bool formula = !text.empty() && (text[0] == '=' || text[0] == '+' || text[0] == '-' || text[0] == '@');
    const std::string safe = formula ? fmt::format("'{}", text) : text;
    if (safe.find_first_of(",\"\r\n") == std::string::npos) return safe;
    std::string quoted = "\"";
    for (const char c : safe) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + "\"";
}

std::string quantities_csv(const Comparison& comparison) {
    std::string out = "name,unit";
    for (const std::string& n : comparison.names) out += fmt::format(",{},{}", csv_cell(n), csv_cell(n + " interval"));
    out += ",difference,interval,per_cent,verdict,judged,remark\n";
    for (const Quantity& q : comparison.quantities) {
        out += csv_cell(q.name) + "," + csv_cell(q.unit);
        for (const MeanValue& m : q.values)
            out += m.known ? fmt::format(",{},{}", number(m.value), number(m.half_width)) : ",,";
        out += fmt::format(",{},{},{},{},{},{}\n", number(q.difference), number(q.interval), number(q.per_cent),
                           to_string(q.verdict), q.judged ? "yes" : "no", csv_cell(q.remark));
    }
    return out;
}

std::string series_csv(const Comparison& comparison) {
    constexpr std::size_t most_rows = 5000;
    fmt::memory_buffer out;
    fmt::format_to(std::back_inserter(out), "source,table,column,unit,time,value\n");
    const auto add = [&](const std::string& source, const Table& table) {
        const std::size_t stride = 1 + table.time.size() / most_rows;
        for (const Column& c : table.columns) {
            const std::string head =
                csv_cell(source) + "," + csv_cell(table.name) + "," + csv_cell(c.name) + "," + csv_cell(c.unit) + ",";
            for (std::size_t i = 0; i < table.time.size(); i += stride)
                fmt::format_to(std::back_inserter(out), "{}{},{}\n", head, table.time[i], number(c.values[i]));
        }
    };
    for (std::size_t s = 0; s < comparison.sources.size(); ++s) {
        for (const auto& [name, table] : comparison.sources[s].tables) add(comparison.names[s], table);
        add(comparison.names[s], comparison.analyses[s].splash);
    }
    return fmt::to_string(out);
}

}  // namespace tw

#include "import/import.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/arguments/output.h"
#include "base/errors.h"
#include "base/folder_lock.h"
#include "compare/report/report_table.h"

namespace tw::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Lowest and highest finite value of a series, and how many values are finite.
struct Span {
    double lowest = std::nan(""), highest = std::nan("");
    std::size_t known = 0;
};
Span span_of(const Column& column) {
    Span s;
    for (const double v : column.values) {
        if (!std::isfinite(v)) continue;
        s.lowest = s.known == 0 ? v : std::min(s.lowest, v);
        s.highest = s.known == 0 ? v : std::max(s.highest, v);
        ++s.known;
    }
    return s;
}

/// What was read: a wrong unit, sign or column shows in the ranges.
std::string text_of(const RunRecord& record) {
    std::string out = fmt::format("{}: {} from {}{}\n", record.attributes.at("method"),
                                  record.attributes.at("import_kind"), record.attributes.at("imported_from"),
                                  record.attributes.at("symmetry_factor") == "2" ? ", half model: loads doubled" : "");
    ReportTable all{
        "",
        {words("table"), words("column"), words("unit"), numbers("lowest", "", 4), numbers("highest", "", 4),
         numbers("rows", "", 6), numbers("without a number", "", 6), numbers("from", "s", 6), numbers("to", "s", 6)}};
    for (const auto& [name, table] : record.tables)
        for (const Column& c : table.columns) {
            const Span s = span_of(c);
            all.rows.push_back({{name, c.name, c.unit, s.lowest, s.highest, table.time.size(),
                                 c.values.size() - s.known, table.time.front(), table.time.back()}});
        }
    out += text_of(all);
    if (!record.frames.empty())
        out += fmt::format("water: {} frames from {:.6g} to {:.6g} s\n", record.frames.size(),
                           record.frames.front().time, record.frames.back().time);
    return out;
}

std::string json_of(const RunRecord& record, const fs::path& file) {
    Json tables = Json::array();
    for (const auto& [name, table] : record.tables) {
        Json columns = Json::array();
        for (const Column& c : table.columns) {
            const Span s = span_of(c);
            columns.push_back({{"name", c.name},
                               {"unit", c.unit},
                               {"values", s.known},
                               {"lowest", s.lowest},
                               {"highest", s.highest}});
        }
        tables.push_back({{"name", name},
                          {"rows", table.time.size()},
                          {"from", table.time.front()},
                          {"to", table.time.back()},
                          {"columns", columns}});
    }
    const Json facts = {{"method", record.attributes.at("method")},
                        {"kind", record.attributes.at("import_kind")},
                        {"source", record.attributes.at("imported_from")},
                        {"record", file.string()},
                        {"tables", tables}};
    return facts.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

int run_import(const ImportCommand& command, const Common& common) {
    const fs::path file = command.out / "record.h5";
    const auto refuse_existing = [&] {
        std::error_code none;
        for (const char* own : {"checkpoint.h5", "case"})
            if (fs::exists(command.out / own, none))
                throw InputError(command.out.string() + ": there is a run of twinwake in it; choose another --out");
        if (!command.overwrite && fs::exists(file, none))
            throw InputError(file.string() + ": exists already; choose another --out, or replace it with --overwrite");
    };
    refuse_existing();
    const RunRecord record = import_record(command.mapping);
    const FolderLock lock(command.out);
    refuse_existing();
    for (const auto& [name, gap] : record.attributes)
        if (name.starts_with("gap:"))
            complain(fmt::format("{}: {}: {}", record.attributes.at("imported_from"), name.substr(4), gap));
    leaving_files([&] { write_record(file, record); });
    say(common, text_of(record) + file.string() +
                    ": written; compare it with runs of the scene, e.g. twinwake compare " +
                    "runs/my/sph runs/my/fvm " + command.out.string() + "\n");
    write_json(common, json_of(record, file));
    return done;
}

}  // namespace tw::app

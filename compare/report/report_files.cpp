#include "compare/report/report_files.h"

#include <fmt/format.h>

#include <cmath>

#include "base/atomic_file.h"
#include "base/read_file.h"
#include "compare/metrics/box_walls.h"
#include "compare/report/comparison_tables.h"
#include "compare/report/escape.h"
#include "compare/report/numbers.h"
#include "compare/report/report_table.h"
#include "compare/report/sentences.h"
#include "compare/report/svg_plot.h"
#include "compare/verdict/judge.h"

namespace tw {
namespace fs = std::filesystem;
namespace {

std::string csv_number(double v) { return std::isfinite(v) ? fmt::format("{}", v) : ""; }

}  // namespace

ReportFiles write_report(const Comparison& comparison, const fs::path& folder, const std::string& details) {
    make_own_folder(folder / "figures");
    const Figures figures = draw_figures(comparison);
    for (const auto* list : {&figures.forces, &figures.splash, &figures.wetting, &figures.cuts, &figures.probes,
                             &figures.bodies, &figures.maps, &figures.resolution})
        for (const Figure& f : *list)
            if (const std::string text = svg_file(f.plot.svg); !text.empty())
                write_text_atomically(folder / "figures" / (f.file + ".svg"), text);
    for (std::size_t s = 0; s < figures.pictures.free_surface.size(); ++s) {
        if (!figures.pictures.free_surface[s].empty())
            write_text_atomically(folder / "figures" / fmt::format("free_surface_{}.png", s),
                                  figures.pictures.free_surface[s]);
        if (!figures.pictures.hull_pressure[s].empty())
            write_text_atomically(folder / "figures" / fmt::format("hull_pressure_{}.png", s),
                                  figures.pictures.hull_pressure[s]);
    }
    write_text_atomically(folder / "quantities.csv", quantities_csv(comparison));
    write_text_atomically(folder / "series.csv", series_csv(comparison));
    const ReportFiles files{folder / "report.html", folder / "report.json", folder / "quantities.csv"};
    write_text_atomically(files.json, comparison_json(comparison));
    write_text_atomically(files.html, report_html(comparison, figures, details));
    return files;
}

std::string quantities_csv(const Comparison& comparison) {
    ReportTable table{"", {words("name"), words("unit")}};
    for (const std::string& n : comparison.names) {
        table.columns.push_back(numbers(n));
        table.columns.push_back(numbers(n + " interval"));
    }
    for (const char* name : {"difference", "interval", "per_cent", "verdict", "judged", "remark"})
        table.columns.push_back(words(name));
    for (const std::string& n : comparison.names)
        for (const char* part : {" scatter", " discretisation"}) table.columns.push_back(numbers(n + part));
    table.columns.push_back(words("sentence"));
    const std::vector<Difference> pairs = pairs_of(comparison.names.size());
    for (const Difference& d : pairs)
        for (const char* part : {"", " interval", " per_cent", " verdict"})
            table.columns.push_back(words(comparison.names[d.b] + " - " + comparison.names[d.a] + part));
    for (const Quantity& q : comparison.quantities) {
        ReportRow row{{q.name, q.unit}};
        for (const MeanValue& m : q.values) {
            row.cells.push_back(m.known ? ReportCell(m.value) : ReportCell());
            row.cells.push_back(m.known ? ReportCell(m.bar()) : ReportCell());
        }
        for (const ReportCell& cell :
             {ReportCell(q.difference), ReportCell(q.interval), ReportCell(q.per_cent),
              ReportCell(to_string(q.verdict)), ReportCell(q.judged ? "yes" : "no"), ReportCell(q.remark)})
            row.cells.push_back(cell);
        for (const MeanValue& m : q.values) {
            row.cells.push_back(m.known ? ReportCell(m.half_width) : ReportCell());
            row.cells.push_back(m.known ? ReportCell(m.discretisation) : ReportCell());
        }
        row.cells.emplace_back(q.sentence);
        for (const Difference& d : q.pairs) {
            row.cells.insert(row.cells.end(),
                             {ReportCell(d.difference), ReportCell(d.interval), ReportCell(d.per_cent)});
            row.cells.emplace_back(to_string(d.verdict));
        }
        table.rows.push_back(std::move(row));
    }
    return csv_of(table);
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
                fmt::format_to(std::back_inserter(out), "{}{},{}\n", head, table.time[i], csv_number(c.values[i]));
        }
    };
    for (std::size_t s = 0; s < comparison.sources.size(); ++s) {
        for (const auto& [name, table] : comparison.sources[s].tables) add(comparison.names[s], table);
        add(comparison.names[s], comparison.analyses[s].splash);
        for (const Table& entry : comparison.analyses[s].entries) add(comparison.names[s], entry);
    }
    return fmt::to_string(out);
}

std::string summary_text(const Comparison& comparison) {
    std::string out;
    for (const std::string& sentence : verdict_sentences(comparison)) out += for_terminal(sentence) + "\n";
    for (const std::string& b : all_banners(comparison)) out += "! " + for_terminal(b) + "\n";
    for (const ReportTable& table :
         {quantities_table(comparison, true), left_out_table(comparison), quantities_table(comparison, false),
          checks_table(comparison.checks, true), cost_table(comparison)})
        if (!table.empty()) out += (out.empty() ? "" : "\n") + text_of(table);
    return out;
}

}  // namespace tw

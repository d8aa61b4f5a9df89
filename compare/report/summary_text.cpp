#include <fmt/format.h>

#include <algorithm>

#include "compare/compare.h"
#include "compare/report/escape.h"
#include "compare/report/numbers.h"

namespace tw {

namespace {

/// Width on a terminal: UTF-8 continuation bytes take no column.
std::size_t columns(const std::string& s) {
    return static_cast<std::size_t>(
        std::ranges::count_if(s, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

std::string table_text(const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> width(rows[0].size(), 0);
    for (const auto& row : rows)
        for (std::size_t c = 0; c < row.size(); ++c) width[c] = std::max(width[c], columns(row[c]));
    std::string out;
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t c = 0; c < row.size(); ++c) {
            const std::string pad(width[c] - columns(row[c]), ' ');
            line += (c == 0 || c + 1 == row.size()) ? row[c] + pad : pad + row[c];
            line += "  ";
        }
        line.erase(line.find_last_not_of(' ') + 1);
        out += line + "\n";
    }
    return out;
}

}  // namespace

std::string summary_text(const Comparison& comparison) {
    std::string out;
    for (const std::string& b : comparison.banners) out += "! " + for_terminal(b) + "\n";
    if (!out.empty()) out += "\n";
    const bool pair = comparison.sources.size() > 1;

    std::vector<std::vector<std::string>> rows{{"", "unit"}};
    for (const std::string& n : comparison.names) rows[0].push_back(for_terminal(n));
    if (pair) rows[0].insert(rows[0].end(), {"difference", "", "verdict"});
    std::string notes;
    for (const Quantity& q : comparison.quantities) {
        if (!q.judged) continue;
        std::vector<std::string> row{for_terminal(q.label), for_terminal(q.unit)};
        for (const MeanValue& m : q.values) row.push_back(mean_text(m));
        if (pair)
            row.insert(row.end(),
                       {signed_text(q.difference, q.interval), per_cent_text(q.per_cent), verdict_label(q.verdict)});
        rows.push_back(std::move(row));
        for (const Reference& r : comparison.references) {
            if (r.quantity != q.name) continue;
            std::vector<std::string> beside{"  " + r.source, r.unit, value_text(r.value, r.half_width)};
            beside.resize(rows[0].size());
            rows.push_back(std::move(beside));
        }
        if (!q.remark.empty()) notes += fmt::format("  {}: {}\n", for_terminal(q.label), for_terminal(q.remark));
    }
    if (rows.size() > 1) out += table_text(rows);
    if (!notes.empty()) out += "\nnotes\n" + notes;
    std::string failed;
    for (const Gate& g : comparison.gates)
        if (!g.pass)
            failed += fmt::format("  {}: {} = {:.3g} {} (limit {:.3g}) {}\n", for_terminal(g.source), g.name, g.value,
                                  g.unit, g.limit, for_terminal(g.remark));
    if (!failed.empty()) out += "\nchecks not met\n" + failed;
    for (std::size_t i = 0; i < comparison.sources.size(); ++i) {
        const RunRecord& r = comparison.sources[i];
        double wall = 0, cpu = 0;
        for (const Phase& p : r.phases) wall += p.wall, cpu += p.cpu;
        if (i == 0) out += "\n";
        if (r.phases.empty()) continue;  // an experiment
        out += fmt::format("{}: {:.4g} elements, {:.4g} steps, {:.3g} s wall, {:.3g} s cpu, {:.3g} MB\n",
                           for_terminal(comparison.names[i]), r.elements, r.steps, wall, cpu, r.peak_memory / 1e6);
    }
    out += "\n" + for_terminal(verdict_sentence(comparison)) + "\n";
    return out;
}

}  // namespace tw

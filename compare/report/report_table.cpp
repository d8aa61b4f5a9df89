#include "compare/report/report_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/report/escape.h"
#include "compare/report/numbers.h"

namespace tw {

namespace {

using Align = ReportColumn::Align;

constexpr const char* unit_column = "unit";  ///< its cells are units

std::string words_of(const ReportCell& cell, const ReportColumn& column) {
    if (!cell.is_number) return column.name == unit_column ? unit_text(cell.text) : cell.text;
    return std::isfinite(cell.number) ? number_text(cell.number, column.digits) : "–";
}

/// Of a file, whose units are plain text.
std::string plain_head_of(const ReportColumn& column) {
    return column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit);
}

std::string head_of(const ReportColumn& column) { return label_text(plain_head_of(column)); }

/// One line that neither steers the terminal nor ends its cell.
std::string one_line(const std::string& text) {
    std::string out;
    for (const char c : for_terminal(text)) {
        if (c == '|') out += '\\';
        out += c == '\n' || c == '\t' ? ' ' : c;
    }
    return out;
}

/// Width on a terminal: UTF-8 continuation bytes take no column.
std::size_t width_of(const std::string& s) {
    return static_cast<std::size_t>(
        std::ranges::count_if(s, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

const char* css_class(Mark mark) {
    switch (mark) {
        case Mark::good: return "agree";
        case Mark::bad: return "differ";
        case Mark::open: return "undecided";
        case Mark::faint: return "not_comparable";
        case Mark::none: break;
    }
    return "";
}

std::string key_html(int source) {
    return source < 0 ? std::string() : fmt::format("<span class=\"key k{}\"></span>", source);
}

const char* align_html(const ReportColumn& column) { return column.align == Align::right ? " class=\"num\"" : ""; }

std::string cell_html(const ReportCell& cell, const ReportColumn& column, std::size_t columns_left) {
    std::string words = escaped(words_of(cell, column));
    if (cell.mark != Mark::none && !words.empty())
        words = fmt::format("<span class=\"badge {}\">{}</span>", css_class(cell.mark), words);
    const std::string span = cell.wide && columns_left > 1 ? fmt::format(" colspan=\"{}\"", columns_left) : "";
    return fmt::format("<td{}{}>{}{}</td>", cell.wide ? " class=\"text\"" : align_html(column), span,
                       key_html(cell.source), words);
}

std::string row_html(const ReportRow& row, const std::vector<ReportColumn>& columns) {
    const std::string kind = std::string(row.beside ? "ref" : "") + (row.remark.empty() ? "" : " has-remark");
    std::string out = kind.empty() ? "<tr>" : "<tr class=\"" + kind.substr(kind[0] == ' ' ? 1 : 0) + "\">";
    for (std::size_t c = 0; c < columns.size(); ++c) {
        const ReportCell& cell = c < row.cells.size() ? row.cells[c] : ReportCell();
        out += cell_html(cell, columns[c], columns.size() - c);
        if (cell.wide) break;
    }
    out += "</tr>";
    if (!row.remark.empty())
        out += fmt::format("<tr class=\"remark\"><td colspan=\"{}\">{}</td></tr>", columns.size(), escaped(row.remark));
    return out;
}

}  // namespace

ReportColumn words(std::string name, std::string unit) {
    return {std::move(name), std::move(unit), Align::left, 3, -1};
}

ReportColumn numbers(std::string name, std::string unit, int digits) {
    return {std::move(name), std::move(unit), Align::right, digits, -1};
}

ReportCell run_cell(const std::string& name, std::size_t source) {
    ReportCell cell(name);
    cell.source = static_cast<int>(source);
    return cell;
}

std::string text_of(const ReportTable& table) {
    if (table.empty()) return {};
    const std::size_t columns = table.columns.size();
    std::vector<std::vector<std::string>> lines(1);
    for (const ReportColumn& c : table.columns) lines[0].push_back(one_line(head_of(c)));
    std::string remarks;
    for (const ReportRow& row : table.rows) {
        auto& line = lines.emplace_back(columns);
        for (std::size_t c = 0; c < std::min(columns, row.cells.size()); ++c) {
            line[c] = one_line(words_of(row.cells[c], table.columns[c]));
            if (row.cells[c].mark == Mark::bad && !line[c].empty()) line[c] = "**" + line[c] + "**";
        }
        if (!row.remark.empty()) remarks += fmt::format("- {}: {}\n", line[0], one_line(row.remark));
    }
    std::vector<std::size_t> width(columns, 3);
    for (std::size_t r = 0; r < lines.size(); ++r)
        for (std::size_t c = 0; c < columns; ++c) {
            const bool wide = r > 0 && c < table.rows[r - 1].cells.size() && table.rows[r - 1].cells[c].wide;
            if (!wide) width[c] = std::max(width[c], width_of(lines[r][c]));
        }
    std::string out = table.title.empty() ? "" : "## " + one_line(table.title) + "\n\n";
    for (std::size_t r = 0; r < lines.size(); ++r) {
        for (std::size_t c = 0; c < columns; ++c) {
            const std::size_t used = width_of(lines[r][c]);
            const std::string pad(used < width[c] ? width[c] - used : 0, ' ');
            const bool right = table.columns[c].align == Align::right;
            out += "| " + (right ? pad + lines[r][c] : lines[r][c] + pad) + " ";
        }
        out += "|\n";
        if (r > 0) continue;
        for (std::size_t c = 0; c < columns; ++c)
            out += "|" + std::string(width[c] + 1, '-') + (table.columns[c].align == Align::right ? ":" : "-");
        out += "|\n";
    }
    if (!remarks.empty()) out += "\n" + remarks;
    if (!table.notes.empty()) out += "\n";
    for (const std::string& note : table.notes) out += one_line(note) + "\n";
    return out;
}

std::string html_of(const ReportTable& table, int heading) {
    if (table.empty()) return {};
    std::string out;
    if (!table.title.empty()) out += fmt::format("<h{0}>{1}</h{0}>", heading, escaped(table.title));
    out += "<div class=\"wide\"><table><thead><tr>";
    for (const ReportColumn& c : table.columns)
        out += fmt::format("<th{}>{}{}</th>", align_html(c), key_html(c.source), escaped(head_of(c)));
    out += "</tr></thead><tbody>";
    for (const ReportRow& row : table.rows) out += row_html(row, table.columns);
    out += "</tbody></table></div>";
    for (const std::string& note : table.notes) out += "<p class=\"note\">" + escaped(note) + "</p>";
    return out + table.picture;
}

std::string text_of(const std::vector<ReportTable>& tables) {
    std::string out;
    for (const ReportTable& table : tables)
        if (!table.empty()) out += "\n" + text_of(table);
    return out;
}

std::string html_of(const std::vector<ReportTable>& tables, int heading) {
    std::string out;
    for (const ReportTable& table : tables) out += html_of(table, heading);
    return out;
}

std::string folded_html(const ReportTable& table) {
    if (table.empty()) return {};
    ReportTable content = table;
    content.title.clear();
    return "<details class=\"fold\"><summary>" + escaped(table.title) + "</summary>" + html_of(content) + "</details>";
}

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

std::string csv_of(const ReportTable& table) {
    std::string out;
    for (std::size_t c = 0; c < table.columns.size(); ++c)
        out += (c > 0 ? "," : "") + csv_cell(plain_head_of(table.columns[c]));
    out += "\n";
    for (const ReportRow& row : table.rows) {
        for (std::size_t c = 0; c < table.columns.size(); ++c) {
            if (c > 0) out += ",";
            if (c >= row.cells.size()) continue;
            const ReportCell& cell = row.cells[c];
            if (!cell.is_number)
                out += csv_cell(cell.text);
            else if (std::isfinite(cell.number))
                out += fmt::format("{:.9g}", cell.number);
        }
        out += "\n";
    }
    return out;
}

}  // namespace tw

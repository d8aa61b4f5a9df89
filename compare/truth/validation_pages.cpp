#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string_view>

#include "base/errors.h"
#include "compare/report/numbers.h"
#include "compare/truth/validation_report.h"
#include "methods/methods.h"

namespace tw {
namespace {

/// Words on lines of at most 120 columns, as the documentation is wrapped; an item of a list stands behind its dash.
std::string wrapped(const std::string& text) {
    std::string out, line;
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        const std::string word = text.substr(at, end - at);
        if (!line.empty() && line.size() + 1 + word.size() > 120)
            out += line + "\n", line = text.starts_with("- ") ? " " : "";
        if (!word.empty()) line += (line.empty() ? "" : " ") + word;
        at = end + 1;
    }
    return out + line + "\n";
}

/// The table, with what is said below it on lines of that length.
std::string table_text(const ReportTable& table) {
    std::string out;
    std::istringstream lines(text_of(table));
    for (std::string line; std::getline(lines, line);)
        out += line.empty() || line.starts_with('|') ? line + "\n" : wrapped(line);
    return out;
}

/// What may not stand in Markdown as it is: text of a suite or a record is text.
std::string plain_markdown(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (std::string_view("\\`*_[]<>|#").find(c) != std::string_view::npos) out += '\\';
        out += c == '\n' ? ' ' : c;
    }
    return out;
}

std::string made_from(const ValidationReport& r) {
    return wrapped(
        fmt::format("This page is made from data by `twinwake validate --pages`: twinwake {}, {}, {}. Do not edit it.",
                    plain_markdown(r.version), plain_markdown(r.machine), plain_markdown(r.date)));
}

/// " SPH: 3 runs, 31 s, with 0.1.0 (4bc74fc4), 2026-11-29."
std::string made_with(const ValidatedCase& c) {
    std::vector<std::string> methods;
    std::string text;
    for (const ValidatedQuantity& q : c.quantities)
        for (const ValidatedValue& v : q.values) {
            if (v.version.empty() || std::ranges::find(methods, v.method) != methods.end()) continue;
            methods.push_back(v.method);
            text += " " + method_label(v.method) + ": ";
            const auto cost = std::ranges::find(c.costs, v.method, &CaseCost::method);
            if (cost != c.costs.end()) text += fmt::format("{} runs, {}, ", cost->runs, time_text(cost->core_seconds));
            text += fmt::format("with {}, {}{}.", plain_markdown(v.version), plain_markdown(v.date),
                                v.kept ? ", kept of an earlier report" : "");
        }
    return text;
}

bool not_run(const ValidatedValue& v, const ValidatedQuantity&) { return v.outcome == Outcome::not_run; }
bool is_enough(const ValidatedValue& v, const ValidatedQuantity& q) {
    return not_run(v, q) || (!falls_short(v, q) && v.outcome != Outcome::failed && v.outcome != Outcome::not_converged);
}

std::string page_of(const ValidatedCase& c) {
    std::string page = "# " + plain_markdown(c.title) + "\n\n" + wrapped(plain_markdown(c.why)) + "\n";
    std::string scenes;
    for (const std::string& scene : c.scenes) scenes += (scenes.empty() ? "" : ", ") + ("`" + scene + "`");
    page += wrapped(fmt::format("Family {}, tier {}; scene {}.{}", c.family, c.tier, scenes, made_with(c))) + "\n";
    if (!c.why_not.empty()) page += wrapped("**Not run with this version:** " + plain_markdown(c.why_not)) + "\n";
    page += table_text(short_table(c)) + "\n";
    page += "## Where the truths are from\n\n";
    for (const ValidatedQuantity& q : c.quantities)
        page +=
            wrapped("- " + plain_markdown(q.label) + " (" + q.truth.standing + "): " + plain_markdown(q.truth.source));
    page += "\n";
    if (!c.shows.empty()) page += "## What it shows\n\n" + wrapped(plain_markdown(c.shows)) + "\n";
    if (!c.shows_not.empty()) page += "## What it does not show\n\n" + wrapped(plain_markdown(c.shows_not)) + "\n";
    ReportTable parts = parts_table(c);
    if (const std::string title = std::exchange(parts.title, ""); !parts.empty())
        page += "## " + title + "\n\n" + table_text(parts) + "\n";
    return page + "Made from data by `twinwake validate --pages`; do not edit.\n";
}

/// The report without the values of which `left_out` says so.
template <class LeftOut>
ValidationReport report_without(ValidationReport report, const LeftOut& left_out) {
    for (ValidatedCase& c : report.cases) {
        for (ValidatedQuantity& q : c.quantities)
            std::erase_if(q.values, [&](const ValidatedValue& v) { return left_out(v, q); });
        std::erase_if(c.quantities, [](const ValidatedQuantity& q) { return q.values.empty(); });
    }
    std::erase_if(report.cases, [](const ValidatedCase& c) { return c.quantities.empty(); });
    return report;
}

}  // namespace

std::string with_tables(const std::string& page, const std::string& name, const ValidationReport& report) {
    constexpr std::string_view begin = "<!-- validate: ", close = " -->\n", end = "<!-- /validate -->";
    std::string out;
    std::size_t at = 0;
    for (std::size_t place = page.find(begin); place != std::string::npos; place = page.find(begin, at)) {
        const std::size_t line = 1 + static_cast<std::size_t>(std::ranges::count(page.substr(0, place), '\n')),
                          word = place + begin.size(), text = page.find(close, word), after = page.find(end, word);
        if (text == std::string::npos || after == std::string::npos || after < text)
            throw InputError(fmt::format("{}:{}: a place for a table has to end: \"{}\" on a line of its own behind it",
                                         name, line, end));
        const std::string table = page.substr(word, text - word);
        ReportTable made;
        const auto by_name = [](const ValidatedCase& c) { return c.name; };
        if (table == "families")
            made = family_table(report);
        else if (table == "values")
            made = short_table(report_without(report, not_run), by_name);
        else if (table == "shortfalls")
            made = short_table(report_without(report, is_enough), by_name);
        else
            throw InputError(fmt::format(
                "{}:{}: no table \"{}\"; there are \"families\", \"values\" and \"shortfalls\"", name, line, table));
        made.title.clear();
        out += page.substr(at, text + close.size() - at) +
               wrapped(fmt::format("Made by `twinwake validate --into` from runs of twinwake {}, {}, {}:",
                                   plain_markdown(report.version), plain_markdown(report.machine),
                                   plain_markdown(report.date))) +
               "\n" + table_text(made) + "\n";
        at = after;
    }
    if (at == 0)
        throw InputError(
            fmt::format("{}: no place for a table: the lines \"{}families -->\" and \"{}\"", name, begin, end));
    return out + page.substr(at);
}

std::vector<MadePage> validation_pages(const ValidationReport& report) {
    std::vector<MadePage> pages;
    std::string index = "# " + plain_markdown(report.title) + "\n\n" + made_from(report) + "\n";
    index += wrapped("Command: `" + report.command + "`, tier " + report.tier + ".") + "\n";
    for (const ValidatedCase& c : report.cases) pages.push_back({c.name + ".md", page_of(c)});
    ReportTable families = family_table(report), estimators = estimators_table(report),
                values =
                    short_table(report, [](const ValidatedCase&c) { return fmt::format("[{0}]({0}.md)", c.name); });
    for (ReportTable* table : {&families, &estimators, &values}) {
        if (table->empty()) continue;  // reports of earlier versions have no estimators
        const std::string title = std::exchange(table->title, "");
        index += "\n## " + title + "\n\n" + table_text(*table);
    }
    pages.insert(pages.begin(), {"README.md", index});
    return pages;
}

}  // namespace tw

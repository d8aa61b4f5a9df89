#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string_view>

#include "base/errors.h"
#include "compare/truth/validation_report.h"

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

std::string page_of(const ValidationReport& report, const ValidatedCase& c) {
    std::string page = "# " + plain_markdown(c.title) + "\n\n" + wrapped(plain_markdown(c.why)) + "\n";
    std::string scenes;
    for (const std::string& scene : c.scenes) scenes += (scenes.empty() ? "" : ", ") + ("`" + scene + "`");
    page += wrapped(fmt::format("**Family** {}. **Tier** {}. **Scene** {}.", c.family, c.tier, scenes)) + "\n";
    if (!c.why_not.empty()) page += wrapped("**Not run with this version:** " + plain_markdown(c.why_not)) + "\n";
    page += table_text(validation_table(c)) + "\n";
    if (!c.versions.empty())
        page += wrapped(plain_markdown(fmt::format("Runs made with twinwake {}.", fmt::join(c.versions, ", ")))) + "\n";
    page += "## Where the truths are from\n\n";
    for (const ValidatedQuantity& q : c.quantities)
        page +=
            wrapped("- " + plain_markdown(q.label) + " (" + q.truth.standing + "): " + plain_markdown(q.truth.source));
    page += "\n";
    if (!c.shows.empty()) page += "## What it shows\n\n" + wrapped(plain_markdown(c.shows)) + "\n";
    if (!c.shows_not.empty()) page += "## What it does not show\n\n" + wrapped(plain_markdown(c.shows_not)) + "\n";
    ReportTable parts = parts_table(c), by_method = estimators_table(c), costs = cost_table(c);
    for (ReportTable* table : {&parts, &by_method, &costs})
        if (const std::string title = std::exchange(table->title, ""); !table->empty())
            page += "## " + title + "\n\n" + table_text(*table) + "\n";
    return page + made_from(report);
}

/// The report without the cases and methods that were not run.
ValidationReport only_run(ValidationReport report) {
    for (ValidatedCase& c : report.cases) {
        for (ValidatedQuantity& q : c.quantities)
            std::erase_if(q.values, [](const ValidatedValue& v) { return v.outcome == Outcome::not_run; });
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
        if (table == "families")
            made = family_table(report);
        else if (table == "values")
            made = validation_table(only_run(report));
        else
            throw InputError(
                fmt::format("{}:{}: no table \"{}\"; there are \"families\" and \"values\"", name, line, table));
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
    index += "## The cases\n\n";
    for (const ValidatedCase& c : report.cases) {
        index += wrapped(fmt::format(
            "- [{}]({}.md), {}: {}", plain_markdown(c.title), c.name, c.family,
            c.why_not.empty() ? plain_markdown(c.why) : "not run with this version: " + plain_markdown(c.why_not)));
        pages.push_back({c.name + ".md", page_of(report, c)});
    }
    ReportTable families = family_table(report), estimators = estimators_table(report),
                values = validation_table(report);
    for (ReportTable* table : {&families, &estimators, &values}) {
        if (table->empty()) continue;  // reports of earlier versions have no estimators
        const std::string title = std::exchange(table->title, "");
        index += "\n## " + title + "\n\n" + table_text(*table);
    }
    pages.insert(pages.begin(), {"README.md", index});
    return pages;
}

}  // namespace tw

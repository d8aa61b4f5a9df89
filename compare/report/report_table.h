#pragma once
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace tw {

/// How a cell stands out: a badge on the page, and what is bad in ** on a terminal.
enum class Mark { none, good, bad, open, faint };

struct ReportColumn {
    enum class Align { left, right };
    std::string name, unit;
    Align align = Align::left;
    int digits = 3;   ///< significant ones of a number that comes without words
    int source = -1;  ///< colour key of a run on the page; -1: none
};
ReportColumn words(std::string name, std::string unit = {});
ReportColumn numbers(std::string name, std::string unit = {}, int digits = 3);

/// Words, or a number whose digits the column decides; a number that is not finite is "–", and nothing in CSV.
struct ReportCell {
    std::string text;
    double number = std::numeric_limits<double>::quiet_NaN();  ///< [unit of the column]
    bool is_number = false;
    Mark mark = Mark::none;
    int source = -1;    ///< colour key on the page
    bool wide = false;  ///< takes the rest of its row

    ReportCell(std::string words = {}, Mark m = Mark::none) : text(std::move(words)), mark(m) {}
    ReportCell(const char* words) : text(words) {}
    template <class Number>
    requires std::is_arithmetic_v<Number> ReportCell(Number n) : number(static_cast<double>(n)), is_number(true) {}
};
/// The name of a run with its colour.
ReportCell run_cell(const std::string& name, std::size_t source);

struct ReportRow {
    std::vector<ReportCell> cells;
    std::string remark = {};  ///< stands below the row on the page, below the table on a terminal
    bool beside = false;      ///< a reference beside the row above
};

/// Facts in rows and columns. Every table of the program is one of these, so the terminal, the page and the files say
/// the same, and text from outside is made harmless in one place.
struct ReportTable {
    std::string title;  ///< empty: none
    std::vector<ReportColumn> columns;
    std::vector<ReportRow> rows = {};
    std::vector<std::string> notes = {};
    std::string picture = {};  ///< markup that stands below it on the page alone: figures, links

    bool empty() const { return rows.empty(); }
};

/// Aligned columns that are markdown as well; a title becomes a heading. Nothing for a table without rows.
std::string text_of(const ReportTable& table);
/// Heading (of that level), table and notes. Nothing for a table without rows.
std::string html_of(const ReportTable& table, int heading = 2);
/// All of them, on a terminal with an empty line before each.
std::string text_of(const std::vector<ReportTable>& tables);
std::string html_of(const std::vector<ReportTable>& tables, int heading = 2);
/// The same under a heading that opens and closes it, closed at first.
std::string folded_html(const ReportTable& table);
/// A header line and the rows by RFC 4180: numbers with nine digits, words as they are. No title, remarks or notes.
std::string csv_of(const ReportTable& table);

/// One cell by RFC 4180; what a spreadsheet would take for a formula is kept as text.
std::string csv_cell(const std::string& text);

}  // namespace tw

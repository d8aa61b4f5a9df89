#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tw {

/// The columns of a text file with one header line, as measuring systems and solvers export it:
///
///   # anything
///   t [s]; Lift [kN]; "Drag; mean"; remark
///   0.00; 2.71; 0.41; start
///   0.01; ; NaN; a cell without a number is NaN
///
/// The first line that is neither empty nor begins with # names the columns. Cells are separated by tabs, semicolons or
/// commas: the first of these that the header line has outside quotes. Cells may stand in "quotes", "" is one quote.
/// Decimal points, not commas. A byte order mark, CR LF line ends and a separator behind the last cell are accepted.
class CsvColumns {
public:
    /// `file`: its name, for messages. Throws InputError `file:line: what was found; what is expected`: binary data, no
    /// header line, one column only, a row of other length, no row.
    CsvColumns(std::string text, std::string file);
    CsvColumns(const CsvColumns&) = delete;  // its rows are views of its text
    CsvColumns& operator=(const CsvColumns&) = delete;

    const std::vector<std::string>& headers() const { return headers_; }
    int header_line() const { return header_line_; }  ///< of the file, from 1
    std::size_t rows() const { return line_.size(); }
    int line(std::size_t row) const { return line_[row]; }  ///< of the file, from 1
    const std::string& file() const { return file_; }
    /// Values of a column, NaN where its cell is empty or NaN. Throws InputError `file:line:column: ...` for the first
    /// cell that holds anything else.
    const std::vector<double>& values(std::size_t column) const;
    /// Of the one column with this header. Throws InputError where there is none or more than one.
    const std::vector<double>& values(std::string_view header) const { return values(column(header)); }
    /// What stands in the cells of a column.
    std::vector<std::string> texts(std::size_t column) const;
    std::vector<std::string> texts(std::string_view header) const { return texts(column(header)); }
    /// Columns whose header is exactly `header`.
    std::vector<std::size_t> find(std::string_view header) const;
    /// "t, Drag, Lift" for messages.
    std::string header_list() const;

private:
    struct Fault {
        int line = 0, column = 0;
        std::string cell;
    };
    void read_header(std::string_view line, int number);
    void read_row(std::string_view line, int number);
    std::size_t column(std::string_view header) const;

    std::string text_, file_;
    char separator_ = ',';
    int header_line_ = 1;
    std::vector<std::string> headers_;
    std::vector<std::vector<double>> values_;        ///< by column
    std::vector<std::optional<Fault>> first_fault_;  ///< by column
    std::vector<int> line_;
    std::vector<std::string_view> rows_;  ///< of text_
};

/// What separates the cells below this header line: the first of tab, semicolon and comma that it has outside quotes.
char separator_of(std::string_view header);
/// Text of a file as it may stand in a message: in quotes, control characters replaced, long ones cut.
std::string shown_cell(std::string_view cell);

}  // namespace tw

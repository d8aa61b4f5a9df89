#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tw {

/// How a measuring system writes its table, as far as the mapping says it; what it leaves open is found in the text.
struct LoggerForm {
    std::string separator = "auto";            ///< auto, tab, semicolon, comma, blank
    std::string decimal = "auto";              ///< auto, point, comma
    std::string clock = "auto";                ///< auto, none, h:m:s, m:s
    std::optional<bool> units_row;             ///< the line below the names of the columns has their units
    std::optional<int> header_line;            ///< of the file, from 1, with the names of the columns; 0: there is none
    std::map<std::string, std::string> place;  ///< of the keys that the mapping gives, for messages
};

/// A logger's table in the form of text/csv_columns.h: every line stands where it stood, lines above the names of the
/// columns are comments, and numbers have decimal points.
struct PlainCsv {
    std::string text;
    std::vector<std::string> units;  ///< of the columns, from the row of units; empty: none is given there
    std::vector<bool> clock;         ///< columns whose times of day have become seconds since their first row
};

/// Finds the form of a logger's text where the mapping leaves it open, and puts it into the plain one. Text that is plain,
/// or in which no table of numbers is found, is given back as it is. Throws InputError `file: ...` where several readings
/// make sense (with the key that decides), and where what the mapping says does not fit.
PlainCsv plain_csv(const std::string& text, const std::string& file, const LoggerForm& form);

}  // namespace tw

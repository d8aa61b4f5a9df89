#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace tw {

/// A refinement study as a user writes it down: one row per level.
struct RefinementTable {
    struct Column {
        std::string name;            ///< from the header line, as written
        std::vector<double> values;  ///< one per row
    };
    std::string spacing_name;
    std::vector<double> spacing;  ///< one per row, in the order of the file, > 0
    std::vector<Column> columns;  ///< the quantities, one or more
};

/// Reads text of the form
///
///   # anything
///   h [m], drag [N], lift [N]
///   0.05, 412.1, 2722
///   0.1, 431, 2690
///
/// in the form of text/csv_columns.h, whose first column is the spacing. Throws InputError
/// `name:line: what was found; what is expected` for anything else: no header, no row, a row of other length, a cell
/// that is not a finite number, a spacing that is not above zero or that was there before.
RefinementTable parse_refinement_table(const std::string& text, const std::string& name);
/// The same of a file; throws InputError where it cannot be read.
RefinementTable read_refinement_table(const std::filesystem::path& file);

}  // namespace tw

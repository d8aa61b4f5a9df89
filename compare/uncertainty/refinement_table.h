#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace tw {

/// A refinement study as a user writes it down: one row per level.
struct RefinementTable {
    struct Column {
        std::string name;            ///< from the header line, as written
        std::vector<double> values;  ///< [unit of the column], one per row
        /// Half a unit of the last place that the column's cells are written to, the finest of them: a program that
        /// prints %g leaves trailing zeros out.
        double rounding = 0;  ///< [unit of the column]
    };
    std::string spacing_name;     ///< as written, or what was made of it: "(cells)^(-1/3)"
    std::vector<double> spacing;  ///< [unit of the column], > 0, one per row, in the order of the file
    std::vector<Column> columns;  ///< the quantities, one or more
};

/// Reads text of the form
///
///   # anything
///   h [m], drag [N], lift [N]
///   0.05, 412.1, 2722
///   0.1, 431, 2690
///
/// in the form of text/csv_columns.h, whose first column is the spacing, or a count or a number per length from which
/// it follows, by the words of its header (`dimensions` is that of a count, 0 where only the header may say it). Throws
/// InputError
/// `name:line: what was found; what is expected` for anything else: no header, no row, a row of other length, a cell
/// that is not a finite number, a size that is not above zero or that was there before, a first column of unclear
/// meaning.
RefinementTable parse_refinement_table(const std::string& text, const std::string& name, int dimensions = 0);
/// The same of a file; throws InputError where it cannot be read.
RefinementTable read_refinement_table(const std::filesystem::path& file, int dimensions = 0);

}  // namespace tw

#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace tw {

/// One column of a table of time series.
struct Column {
    std::string name, unit;
    std::vector<double> values;  ///< one for each time of its table [`unit`]
};

/// Series that share their times, e.g. "forces" (one row per step) or "samples" (one row per frame).
struct Table {
    std::string name;
    std::vector<double> time;  ///< [s], increasing
    std::vector<Column> columns;
    Column& column(const std::string& name, const std::string& unit);  ///< created when missing
    const Column* find(const std::string& name) const;

    /// Adds a row, whose values are NaN until they are set, and returns its place.
    std::size_t append(double time);
    /// A column that is new has NaN in all other rows.
    void set(std::size_t row, const std::string& name, const std::string& unit, double value);
    /// Drops the rows after `time` [s].
    void rewind(double time);
};

}  // namespace tw

#include "record/run_record.h"

#include <algorithm>

namespace tw {

Column& Table::column(const std::string& column_name, const std::string& unit) {
    for (Column& c : columns)
        if (c.name == column_name) return c;
    return columns.emplace_back(Column{column_name, unit, {}});
}

const Column* Table::find(const std::string& column_name) const {
    const auto found = std::ranges::find(columns, column_name, &Column::name);
    return found == columns.end() ? nullptr : &*found;
}

Table& RunRecord::table(const std::string& table_name) {
    Table& t = tables[table_name];
    t.name = table_name;
    return t;
}

const Column* RunRecord::series(const std::string& table_name, const std::string& column_name) const {
    const auto found = tables.find(table_name);
    return found == tables.end() ? nullptr : found->second.find(column_name);
}

}  // namespace tw

#include "record/run_record.h"

namespace tw {

Table& RunRecord::table(const std::string& table_name) {
    Table& t = tables[table_name];
    t.name = table_name;
    return t;
}

const Column* RunRecord::series(const std::string& table_name, const std::string& column_name) const {
    const auto found = tables.find(table_name);
    return found == tables.end() ? nullptr : found->second.find(column_name);
}

void RunRecord::rewind(double time) {
    for (auto& [name, table] : tables) table.rewind(time);
    std::erase_if(frames, [&](const RasterFrame& f) { return f.time > time; });
}

}  // namespace tw

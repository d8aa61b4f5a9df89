#include "record/empty_twin.h"

#include <fmt/format.h>

#include "record/record_numbers.h"

namespace tw {
namespace {

std::string why_not_of(const RunRecord& record, const RunRecord& twin) {
    const double size = number_of(record, "near_hull", NAN), other = number_of(twin, "near_hull", NAN);
    if (twin.state != "finished") return "it is not finished";
    if (size != other) return fmt::format("it has near_hull = {:.6g} m and the run with bodies {:.6g} m", other, size);
    if (text_of(twin, std::string(empty_twin_of_run)) != text_of(record, "run_hash") ||
        !record.attributes.contains("run_hash"))
        return "it is of another scene or of other numerics";
    if (number_of(twin, "duration", 0) < number_of(record, "duration", 0))
        return fmt::format("it ends at {:.4g} s and the run with bodies at {:.4g} s", number_of(twin, "duration", 0),
                           number_of(record, "duration", 0));
    if (!twin.tables.contains("height")) return "it has no levels";
    return {};
}

}  // namespace

void take_empty_twin(RunRecord& record, const RunRecord& twin) {
    const std::string why_not = why_not_of(record, twin);
    if (!why_not.empty()) {
        record.attributes[std::string(no_empty_twin)] = why_not;
        return;
    }
    record.tables[std::string(empty_twin_table)] = twin.tables.at("height");
}

}  // namespace tw

#include "record/wave_twin.h"

#include <fmt/format.h>

#include "record/hull_motion.h"
#include "record/record_numbers.h"

namespace tw {
namespace {

/// The twin of a hull in a stream has no wave.
bool is_calm(const RunRecord& twin) { return !twin.numbers.contains("wave_period"); }

std::string why_not_of(const RunRecord& record, const RunRecord& twin) {
    const char* whole = is_calm(twin) ? "the run in waves" : "the run with bodies";
    const double size = number_of(record, "near_hull", NAN), other = number_of(twin, "near_hull", NAN);
    if (twin.state != "finished") return "it is not finished";
    if (size != other) return fmt::format("it has near_hull = {:.6g} m and {} {:.6g} m", other, whole, size);
    if (text_of(twin, std::string(wave_twin_of_run)) != text_of(record, "run_hash") ||
        !record.attributes.contains("run_hash"))
        return "it is of another scene or of other numerics";
    if (number_of(twin, "duration", 0) < number_of(record, "duration", 0))
        return fmt::format("it ends at {:.4g} s and {} at {:.4g} s", number_of(twin, "duration", 0), whole,
                           number_of(record, "duration", 0));
    if (!twin.tables.contains(is_calm(twin) ? "forces" : "height"))
        return is_calm(twin) ? "it has no forces" : "it has no levels";
    return {};
}

}  // namespace

void take_wave_twin(RunRecord& record, const RunRecord& twin) {
    const std::string why_not = why_not_of(record, twin);
    if (!why_not.empty()) {
        record.attributes[std::string(no_wave_twin)] = why_not;
        return;
    }
    if (!is_calm(twin)) {
        record.tables[std::string(empty_twin_table)] = twin.tables.at("height");
        return;
    }
    record.tables[std::string(calm_forces_table)] = twin.tables.at("forces");
    if (const auto motion = twin.tables.find(hull_motion_table); motion != twin.tables.end())
        record.tables[std::string(calm_motion_table)] = motion->second;
}

}  // namespace tw

#include "scene/run/run_end.h"

#include <fmt/format.h>

#include "record/record_numbers.h"

namespace tw {
namespace {

SettledStop rule_of(const Scene& scene) { return {.period = scene.run.wave_period}; }

}  // namespace

bool may_end(const Scene& scene, const RunRecord& record) {
    if (!scene.run.stops_when_settled()) return false;
    const SettledStop rule = rule_of(scene);
    return is_look(record, rule) && settled_loads(record, rule).settled;
}

std::string note_end(const Scene& scene, RunRecord& record, std::optional<double> settled) {
    if (!scene.run.stops_when_settled()) return {};
    const std::string loads = settled_loads(record, rule_of(scene)).sentence();
    record.numbers[bound_number] = scene.run.duration;
    record.attributes[ended_by] = settled ? by_settling : at_bound;
    if (!settled)
        return fmt::format("its loads had not settled within its bound of {:.4g} s; {}", scene.run.duration, loads);
    record.numbers["duration"] = *settled;
    return fmt::format("its loads have settled at {:.4g} s of at most {:.4g} s; {}", *settled, scene.run.duration,
                       loads);
}

void forget_end(RunRecord& record) {
    record.attributes.erase(ended_by);
    record.numbers.erase(bound_number);
}

bool is_complete(const Scene& scene, const RunRecord& record) {
    if (record.state != "finished") return false;
    if (number_of(record, "duration", 0) >= scene.run.duration) return true;
    return scene.run.stops_when_settled() && text_of(record, ended_by) == by_settling;
}

}  // namespace tw

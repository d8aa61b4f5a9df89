#include "compare/checks/checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "record/record_numbers.h"
#include "record/recorded_checks.h"

namespace tw {

namespace {

/// Largest finite value of a sample series from `from` on.
std::optional<double> largest(const RunRecord& record, const std::string& column, double from) {
    const Column* c = record.series("samples", column);
    if (!c) return {};
    const auto& time = record.tables.at("samples").time;
    std::optional<double> most;
    for (std::size_t i = 0; i < time.size(); ++i)
        if (time[i] >= from && std::isfinite(c->values[i])) most = std::max(most.value_or(c->values[i]), c->values[i]);
    return most;
}

/// What any run has to show: that it came to its end, and that its water moves as it can.
void add_run_checks(CheckList& list) {
    const RunRecord& record = list.record;
    const double settled = number_of(record, "mean_from", 0), speed = number_of(record, "speed", 0);
    const double duration = number_of(record, "duration", 0);
    double end = 0;
    for (const auto& [table_name, table] : record.tables)
        if (!table.time.empty()) end = std::max(end, table.time.back());
    ValidityCheck finished{"finished", list.name, "s", end, duration, record.state == "finished", record.state};
    // Why a run failed is the first sentence of its report (failures_of).
    if (!record.reason.empty() && record.state != "failed") finished.remark += ": " + record.reason;
    list.checks.push_back(finished);

    if (const auto lost = largest(record, "particles_lost", 0))
        list.add("particles lost", "-", *lost, 0, "no particle may pass a wall");
    if (const auto mach = largest(record, "max_mach", settled))
        list.add("largest Mach number", "-", *mach, 0.15, "weakly compressible: the density varies with its square");
    if (const auto fastest = largest(record, "max_speed", settled); fastest && speed > 0)
        list.add("largest speed over stream", "-", *fastest / number_of(record, "fastest_stream", speed), 3,
                 "spray and air reach 1.6; a larger value indicates a fault");
}

void add_validity_checks(CheckList& list) {
    for (const RecordedCheck& line : list.record.validity_checks) {
        std::string remark = fmt::format("validity check: extreme value of the whole run, at {:.4g} s", line.time);
        if (line.place.allFinite())
            remark += fmt::format(", ({:.3g}, {:.3g}, {:.3g}) m", line.place.x(), line.place.y(), line.place.z());
        list.checks.push_back(
            {line.name, list.name, line.unit, line.value, line.limit, line.met(), remark, only_warns(line)});
    }
}

}  // namespace

std::vector<ValidityCheck> checks_of(const RunRecord& record, const std::string& name) {
    CheckList list{record, name};
    add_run_checks(list);
    add_water_checks(list);
    add_hull_checks(list);
    add_validity_checks(list);
    return std::move(list.checks);
}

std::vector<ValidityCheck> failed_checks(std::vector<ValidityCheck> checks) {
    std::erase_if(checks, [](const ValidityCheck& g) { return g.pass; });
    return checks;
}

}  // namespace tw

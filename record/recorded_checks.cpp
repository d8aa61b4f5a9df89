#include "record/recorded_checks.h"

#include <algorithm>
#include <cmath>

#include "record/body_work.h"
#include "record/tank_table.h"

namespace tw {

bool only_warns(const RecordedCheck& line) {
    return line.name == mass_drift_line || line.name == orphans_line || line.name == interface_line ||
           line.name == crowding_line;
}

void note_worst(RunRecord& record, const RecordedCheck& line) {
    const auto known = std::ranges::find(record.validity_checks, line.name, &RecordedCheck::name);
    if (known == record.validity_checks.end())
        record.validity_checks.push_back(line);
    else if (!(line.value <= known->value))
        *known = line;
}

namespace {

/// Work of the water on the bodies that move, up to a time [J].
double given_to_bodies(const RunRecord& record, double time) {
    double sum = 0;
    for (const auto& [name, table] : record.tables) {
        const Column* work = name.starts_with("body_") ? table.find(body_work) : nullptr;
        const auto after = std::ranges::upper_bound(table.time, time);
        if (work && after != table.time.begin())
            sum += work->values[static_cast<std::size_t>(after - table.time.begin()) - 1];
    }
    return sum;
}

}  // namespace

std::optional<double> energy_made(const RunRecord& record) {
    const auto motion = record.attributes.find("motion");
    if (motion == record.attributes.end() || motion->second != "none") return {};
    const Column *kinetic = record.series("samples", "kinetic_energy"),
                 *potential = record.series("samples", "potential_energy"),
                 *elastic = record.series("samples", "elastic_energy"), *air = record.series("samples", "air_energy"),
                 *work = record.series(tank_table, tank_work);
    if (!kinetic || !potential || kinetic->values.empty()) return {};
    const std::vector<double>& times = record.tables.at("samples").time;
    const auto energy = [&](std::size_t i) {
        return kinetic->values[i] + potential->values[i] + (elastic ? elastic->values[i] : 0) +
               (air ? air->values[i] : 0) - (work ? work->values[i] : 0) + given_to_bodies(record, times[i]);
    };
    const auto surface = record.numbers.find(energy_of_surface);
    return energy(kinetic->values.size() - 1) - energy(0) - (surface == record.numbers.end() ? 0 : surface->second);
}

std::optional<double> energy_of_height(const RunRecord& record) {
    const Column *mass = record.series("samples", "mass"), *potential = record.series("samples", "potential_energy");
    const auto gravity = record.numbers.find("gravity"), floor = record.numbers.find("domain_z_min");
    if (!mass || !potential || mass->values.empty() || gravity == record.numbers.end() || floor == record.numbers.end())
        return {};
    const double above = potential->values.front() - mass->values.front() * gravity->second * floor->second;
    return above > 0 ? std::optional(above) : std::nullopt;
}

void watch_energy(RunRecord& record) {
    const std::optional<double> made = energy_made(record);
    if (!made) return;
    const auto surface = record.numbers.find(energy_of_surface);
    const double scale = std::abs(record.series("samples", "potential_energy")->values.front()) +
                         (surface == record.numbers.end() ? 0 : surface->second);
    if (!(scale > 0)) return;
    RecordedCheck line{"energy made", "%"};
    line.value = 100 * *made / scale;
    line.limit = 1;
    line.time = record.tables.at("samples").time.back();
    note_worst(record, line);
}

}  // namespace tw

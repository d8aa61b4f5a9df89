#include "record/certificate.h"

#include <algorithm>
#include <cmath>

#include "record/tank_table.h"

namespace tw {

bool only_warns(const CertificateLine& line) {
    return line.name == mass_drift_line || line.name == orphans_line || line.name == interface_line;
}

void note_worst(RunRecord& record, const CertificateLine& line) {
    const auto known = std::ranges::find(record.certificate, line.name, &CertificateLine::name);
    if (known == record.certificate.end())
        record.certificate.push_back(line);
    else if (!(line.value <= known->value))
        *known = line;
}

void watch_energy(RunRecord& record) {
    const auto motion = record.attributes.find("motion");
    if (motion == record.attributes.end() || motion->second != "none") return;
    const Column *kinetic = record.series("samples", "kinetic_energy"),
                 *potential = record.series("samples", "potential_energy"),
                 *elastic = record.series("samples", "elastic_energy"), *air = record.series("samples", "air_energy"),
                 *work = record.series(tank_table, tank_work);
    if (!kinetic || !potential || kinetic->values.empty()) return;
    const auto energy = [&](std::size_t i) {
        return kinetic->values[i] + potential->values[i] + (elastic ? elastic->values[i] : 0) +
               (air ? air->values[i] : 0) - (work ? work->values[i] : 0);
    };
    const double scale = std::abs(potential->values.front());
    if (!(scale > 0)) return;
    CertificateLine line{"energy made", "%"};
    line.value = 100 * (energy(kinetic->values.size() - 1) - energy(0)) / scale;
    line.limit = 1;
    line.time = record.tables.at("samples").time.back();
    note_worst(record, line);
}

}  // namespace tw

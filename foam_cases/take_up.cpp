#include "foam_cases/take_up.h"

#include <cstdlib>
#include <utility>

#include "scene/run/run_end.h"

namespace tw {

void take_up(RunRecord earlier, RunRecord& record) {
    record.tables = std::move(earlier.tables);
    record.frames = std::move(earlier.frames);
    record.phases = std::move(earlier.phases);
    record.validity_checks = std::move(earlier.validity_checks);
    record.peak_memory = earlier.peak_memory;
    record.elements = earlier.elements;
    if (!earlier.hull_pressure.empty()) {  // of the last write time, until the next one is read
        record.hull = std::move(earlier.hull);
        record.hull_pressure = std::move(earlier.hull_pressure);
        record.hull_wet = std::move(earlier.hull_wet);
    }
    if (const auto started = earlier.attributes.find("started"); started != earlier.attributes.end())
        record.attributes["started"] = started->second;
    forget_end(earlier);
    record.attributes.merge(earlier.attributes);  // what both have is the new one's
    record.numbers.merge(earlier.numbers);
    record.attributes["restarts"] = std::to_string(std::atoi(record.attributes["restarts"].c_str()) + 1);
}

}  // namespace tw

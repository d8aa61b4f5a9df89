#include "record/measured_value.h"

#include "record/record_numbers.h"
#include "record/run_record.h"

namespace tw {

namespace {
const std::string measured_prefix = "measured_";
}

void note_measured(RunRecord& record, const MeasuredValue& m) {
    const std::string name = measured_prefix + m.quantity;
    record.attributes[name] = m.source;
    record.attributes[name + "_unit"] = m.unit;
    record.numbers[name] = m.value;
    record.numbers[name + "_half_width"] = m.half_width;
}

std::vector<MeasuredValue> measured_values(const RunRecord& record) {
    std::vector<MeasuredValue> all;
    for (const auto& [name, value] : record.numbers) {
        if (!name.starts_with(measured_prefix) || !record.attributes.contains(name + "_unit")) continue;
        all.push_back({name.substr(measured_prefix.size()), text_of(record, name + "_unit"), text_of(record, name),
                       value, number_of(record, name + "_half_width", 0)});
    }
    return all;
}

}  // namespace tw

#pragma once
#include <string>
#include <vector>

namespace tw {

struct RunRecord;

/// The measured value of a quantity, which reports show beside the runs; no run depends on it.
struct MeasuredValue {
    std::string quantity;              ///< its name in the report, as "lift"
    std::string unit, source;          ///< as written; who measured it
    double value = 0, half_width = 0;  ///< [SI, as `unit`]; half_width: of the 95 % interval, 0: not known
};
/// In a record: numbers `measured_NAME` and `measured_NAME_half_width`, attributes `measured_NAME` (the source) and
/// `measured_NAME_unit`.
void note_measured(RunRecord& record, const MeasuredValue& measured);
/// In the order of the names of their quantities.
std::vector<MeasuredValue> measured_values(const RunRecord& record);

}  // namespace tw

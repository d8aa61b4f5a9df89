#pragma once
#include "record/run_record.h"

namespace tw {

/// Length over speed [s]: the settled wetted length where the record knows it, else what the undisturbed water would
/// wet; 0 in a tank.
double flow_through_time(const RunRecord& record);

}  // namespace tw

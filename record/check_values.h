#pragma once
#include <string>

#include "record/run_record.h"

namespace tw {

/// Refuses a record whose scalars cannot be: numbers, costs, sizes, limits and times that are not finite, times that do
/// not increase, negative counts, lengths that are not positive. Throws InputError: file, key, value and what was
/// expected.
///
/// NaN in a series' column or in the hull's pressure means "not known" and stays. In the record of a failed run a
/// validity checks line may hold any value: that is what the run failed of.
void check_values(const std::string& file, const RunRecord& record);

}  // namespace tw

#pragma once
#include <string>

#include "record/run_record.h"

namespace tw {

// Solids that stay where they are stand among a record's bodies too, under a name to which no table of a motion belongs.

/// The name of an obstacle among them.
inline std::string obstacle_table(const std::string& name) { return "obstacle_" + name; }
inline bool is_at_rest(const BodyShape& body) { return body.table.starts_with("obstacle_"); }

}  // namespace tw

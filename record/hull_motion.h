#pragma once

namespace tw {

/// The table of a hull that is free in a stream, what a towing tank measures, one row per step: height of the centre of
/// gravity above still water, `z` [m], and its velocity upward `vz` [m/s]; `trim`, bow up [deg], and its rate
/// `trim_rate` [deg/s]; `transom_draft`, the depth of the transom's keel below still water [m].
inline constexpr const char* hull_motion_table = "hull_motion";

}  // namespace tw

#pragma once

namespace tw {

/// Of a tank that moves, one row for each frame: the mean force of the water on it since the row before (fx, fy, fz, in
/// its own axes), and the work that its motion has done on the water since the start.
inline constexpr const char* tank_table = "tank";
inline constexpr const char* tank_work = "work";

}  // namespace tw

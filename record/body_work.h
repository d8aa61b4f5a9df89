#pragma once

namespace tw {

/// Column of the table of a body that moves: what the water has done on it since the table's first row [J], per metre of
/// span in two dimensions.
inline constexpr const char* body_work = "work";

}  // namespace tw

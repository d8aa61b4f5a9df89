#pragma once

namespace tw {

// The names of the two methods, for code that concerns one of them alone; all others go through methods.h.
inline constexpr const char* sph_method = "sph";
inline constexpr const char* fvm_method = "fvm";

}  // namespace tw

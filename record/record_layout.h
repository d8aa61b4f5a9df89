#pragma once
#include <string>

namespace tw::layout {

// Names inside a run record's HDF5 file; docs: see run_record.h.
inline const std::string kind = "twinwake run record";
inline constexpr const char* kind_attribute = "kind";
inline constexpr const char* version_attribute = "format_version";
inline constexpr const char* attributes = "attributes";
inline constexpr const char* numbers = "numbers";
inline constexpr const char* scene_text = "scene_text";
inline constexpr const char* tables = "tables";
inline constexpr const char* raster = "raster";
inline constexpr const char* hull = "hull";
inline constexpr const char* bodies = "bodies";
inline constexpr const char* cost = "cost";
inline constexpr const char* effects = "effects";
inline constexpr const char* bounds = "bounds";  ///< in effects
inline constexpr const char* validity_checks = "certificate";
inline constexpr const char* resolution = "resolution";

}  // namespace tw::layout

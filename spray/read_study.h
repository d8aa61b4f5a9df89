#pragma once
#include <filesystem>

#include "spray/study.h"

namespace tw::spray {

/// Reads what `twinwake spray` computes from a TOML file; paths are relative to it. Water's density, gravity and the
/// half model come from the run's record where the file does not give them. Throws InputError `file:line:column: ...`.
SprayStudy read_spray_study(const std::filesystem::path& file);

/// Every section and key with its meaning, for --help.
extern const char* const spray_study_help;

}  // namespace tw::spray

#pragma once
#include <filesystem>

#include "record/run_record.h"

namespace tw::app {

/// The record of a run, with what its twin measured where that lies beside it (record/wave_twin.h). Throws InputError as
/// read_record.
RunRecord read_run(const std::filesystem::path& record_file);

}  // namespace tw::app

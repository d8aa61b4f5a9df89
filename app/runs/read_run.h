#pragma once
#include <filesystem>

#include "record/run_record.h"

namespace tw::app {

/// Where the record of a run's empty twin lies (record/empty_twin.h): FOLDER/without_bodies/METHOD beside FOLDER/METHOD.
std::filesystem::path folder_of_empty_twin(const std::filesystem::path& run_folder);
inline constexpr const char* empty_twins_folder = "without_bodies";

/// The record of a run, with what its empty twin measured where that lies beside it. Throws InputError as read_record.
RunRecord read_run(const std::filesystem::path& record_file);

}  // namespace tw::app

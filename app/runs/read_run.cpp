#include "app/runs/read_run.h"

#include "base/errors.h"
#include "record/empty_twin.h"

namespace tw::app {

namespace fs = std::filesystem;

fs::path folder_of_empty_twin(const fs::path& run_folder) {
    return run_folder.parent_path() / empty_twins_folder / run_folder.filename();
}

RunRecord read_run(const fs::path& record_file) {
    RunRecord record = read_record(record_file);
    const fs::path twin = folder_of_empty_twin(fs::absolute(record_file).parent_path()) / "record.h5";
    if (!fs::exists(twin)) return record;
    try {
        take_empty_twin(record, read_record(twin));
    } catch (const InputError& e) { record.attributes[std::string(no_empty_twin)] = e.what(); }
    return record;
}

}  // namespace tw::app

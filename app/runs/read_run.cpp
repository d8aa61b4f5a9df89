#include "app/runs/read_run.h"

#include "base/errors.h"
#include "record/wave_twin.h"

namespace tw::app {

namespace fs = std::filesystem;

RunRecord read_run(const fs::path& record_file) {
    RunRecord record = read_record(record_file);
    const fs::path run = fs::absolute(record_file).parent_path();
    for (const std::string_view coarser_members : {empty_twins_folder, calm_twins_folder}) {
        const fs::path twin = run.parent_path() / coarser_members / run.filename() / "record.h5";
        if (!fs::exists(twin)) continue;
        try {
            take_wave_twin(record, read_record(twin));
        } catch (const InputError& e) { record.attributes[std::string(no_wave_twin)] = e.what(); }
    }
    return record;
}

}  // namespace tw::app

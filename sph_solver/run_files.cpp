#include "sph_solver/run_files.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "base/errors.h"

namespace tw {
namespace fs = std::filesystem;

RunFiles::RunFiles(const std::filesystem::path& folder, std::string run_hash, const Comm& ranks, bool beside_steps)
    : record_(folder / "record.h5"),
      checkpoint_(folder / "checkpoint.h5"),
      run_hash_(std::move(run_hash)),
      ranks_(ranks),
      beside_steps_(beside_steps),
      pictures_(folder) {}

void RunFiles::write(RunOutput output) {
    if (!beside_steps_) return ranks_.on_first([&] { write_here(output); });
    if (!beside_) beside_ = std::make_unique<SideThread>();
    beside_->begin([this, kept = std::make_shared<RunOutput>(std::move(output))] { write_here(*kept); });
}

void RunFiles::finish() {
    if (beside_) beside_->finish();
}

void RunFiles::remove() const {
    for (const std::filesystem::path& file : {record_, checkpoint_, pictures_.folder()})
        std::filesystem::remove_all(file);
}

/// The record before the checkpoint: one whose rows are not all in a record is never gone on from.
void RunFiles::write_here(RunOutput& output) {
    if (output.picture) pictures_.write(*std::exchange(output.picture, {}));
    if (output.record) write_record(record_, *std::exchange(output.record, {}));
    if (output.checkpoint) write_checkpoint(checkpoint_, run_hash_, *std::exchange(output.checkpoint, {}));
}

std::optional<EarlierRun> earlier_run(const RunFiles& files, const std::string& run_hash, bool with_particles) {
    const fs::path &record_file = files.record(), &checkpoint_file = files.checkpoint();
    EarlierRun run;
    if (fs::exists(record_file)) {
        run.record = read_record(record_file);
        if (run.record.attributes["run_hash"] != run_hash)
            throw InputError(record_file.string() +
                             ": belongs to another scene (or the scene file was changed); run in another folder or "
                             "with --overwrite");
        if (!fs::exists(checkpoint_file) && run.record.state != "finished") return {};
    }
    run.checkpoint = read_checkpoint(checkpoint_file, run_hash, with_particles);
    const double time = run.checkpoint.levels.front().state.time;
    const std::vector<double>& frames = run.record.table("samples").time;
    if (frames.empty() || frames.back() < time)
        throw InputError(
            fmt::format("{}: {}, and its checkpoint is of {:.6g} s: what was recorded in between would be "
                        "missing; put the record back or begin anew with --overwrite",
                        record_file.string(),
                        frames.empty() ? "there is no row of samples in it, or no such file"
                                       : fmt::format("it ends at {:.6g} s", frames.back()),
                        time));
    return run;
}

}  // namespace tw

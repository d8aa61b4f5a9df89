#include "sph_solver/run_files.h"

#include <utility>

namespace tw {

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

}  // namespace tw

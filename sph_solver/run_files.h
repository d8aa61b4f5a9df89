#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "base/side_thread.h"
#include "record/run_record.h"
#include "sph_solver/measure/pictures.h"
#include "sph_solver/parallel/comm.h"
#include "sph_solver/state/checkpoint.h"

namespace tw {

/// What a run writes of one moment. It owns all of it, so that the run may go on meanwhile.
struct RunOutput {
    std::optional<Picture> picture;
    std::optional<RunRecord> record;
    std::optional<Checkpoint> checkpoint;
};

/// The files of a particle run: record.h5, checkpoint.h5, snapshots/. Each is whole at any time, and they are written
/// in the order of their moments: at most one moment's at a time. Nobody else in this process may use HDF5 meanwhile,
/// which knows no threads.
class RunFiles {
public:
    /// `beside_steps`: a thread of its own writes them, for a process by itself. Of several ranks the first one writes,
    /// and the others wait for it, so that all hear what keeps it from that.
    RunFiles(const std::filesystem::path& folder, std::string run_hash, const Comm& ranks, bool beside_steps);

    const std::filesystem::path& record() const { return record_; }
    const std::filesystem::path& checkpoint() const { return checkpoint_; }
    /// After a restart: pictures up to `time` are there.
    void find_written(double time) { pictures_.find_written(time); }
    /// All ranks call it. Throws what kept it, or the output before it, from being written.
    void write(RunOutput output);
    void finish();  ///< waits until all is written; throws the same
    /// Those of an earlier run; in a folder where nothing is being written.
    void remove() const;
    /// Processor time of the thread beside the steps [s]; 0: there is none.
    double cpu() const { return beside_ ? beside_->cpu() : 0; }

private:
    void write_here(RunOutput& output);

    std::filesystem::path record_, checkpoint_;
    std::string run_hash_;
    const Comm& ranks_;
    bool beside_steps_;
    Pictures pictures_;
    std::unique_ptr<SideThread> beside_;  // from the first output on; the last: it works with all of the above
};

/// A run that can be resumed: its last checkpoint, and the record that leads to it.
struct EarlierRun {
    RunRecord record;
    Checkpoint checkpoint;
};

/// `with_particles`: as read_checkpoint has it. Nothing: the run was stopped before its first checkpoint and begins
/// again. Throws InputError naming the file that is missing, of another scene, or ends too early.
std::optional<EarlierRun> earlier_run(const RunFiles& files, const std::string& run_hash, bool with_particles);

}  // namespace tw

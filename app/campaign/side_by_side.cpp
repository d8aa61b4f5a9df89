#include "app/campaign/side_by_side.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <memory>
#include <numeric>
#include <thread>

#include "app/arguments/output.h"
#include "app/cluster/slurm.h"
#include "app/runs/solvers.h"
#include "app/terminal/environment_here.h"
#include "app/terminal/progress_bar.h"
#include "app/terminal/stop_signal.h"
#include "base/errors.h"
#include "foam_cases/run/child.h"
#include "record/this_machine.h"
#include "sph_solver/choose_passes.h"

namespace tw::app {
namespace {

namespace fs = std::filesystem;
using Kind = MemberState::Kind;

class SideBySide {
public:
    SideBySide(const Study& study, const Sharing& sharing, const Common& common)
        : study_(study),
          jobs_(sharing.jobs),
          one_core_each_(sharing.one_core_each),
          common_(common),
          states_(study.members.size()),
          bar_("runs", common.quiet) {
        queue_.resize(study.members.size());
        std::iota(queue_.begin(), queue_.end(), 0);
        std::ranges::stable_sort(queue_, std::greater{}, [&](std::size_t k) { return study_.members[k].seconds; });
        for (const Member& m : study.members) work_ += m.seconds;
    }

    std::vector<MemberState> run() {
        while ((!queue_.empty() && !stop_asked()) || !running_.empty()) {
            while (begin_next()) {}
            if (stop_asked() && !std::exchange(told_, true))
                for (Running& r : running_) r.child->signal_group(SIGTERM);
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
            std::erase_if(running_, [&](Running& r) { return has_ended(r); });
            show();
        }
        return std::move(states_);
    }

private:
    struct Running {
        std::size_t number;
        int cores;
        std::unique_ptr<ChildProcess> child;
    };

    /// Starts the longest of those that wait, if there is room for it.
    bool begin_next() {
        if (stop_asked() || queue_.empty() || static_cast<int>(running_.size()) >= jobs_) return false;
        int used = 0;
        double bytes = 0;
        for (const Running& r : running_) used += r.cores, bytes += study_.members[r.number].bytes;
        const Member& next = study_.members[queue_.front()];
        const int cores = cores_of(next, cores_ - used);
        const bool room = cores <= cores_ - used && bytes + next.bytes <= memory_for_jobs();
        if (!room && !running_.empty()) return false;
        begin(queue_.front(), cores);
        queue_.erase(queue_.begin());
        return true;
    }

    int cores_of(const Member& m, int free) const {
        if (m.request.threads > 0) return m.request.threads * m.request.ranks;
        if (const double least = solver_of(m.method).elements_per_rank; least > 0)
            return one_core_each_ ? 1 : std::clamp(static_cast<int>(m.elements / least), 1, cores_);
        std::vector<double> waiting;
        for (std::size_t k = 0; k < queue_.size() && waiting.size() + running_.size() < static_cast<std::size_t>(jobs_);
             ++k)
            waiting.push_back(study_.members[queue_[k]].seconds);
        return std::max(share_of_cores(waiting, free), m.request.ranks);
    }

    void begin(std::size_t k, int cores) {
        std::vector<std::string> words{"member", study_.out.string(), std::to_string(k), "--quiet"};
        const Member& m = study_.members[k];
        if (m.request.threads == 0 && (one_core_each_ || solver_of(m.method).elements_per_rank == 0))
            words.insert(words.end(), {"--threads", std::to_string(cores / m.request.ranks)});
        running_.push_back(
            {k, cores,
             std::make_unique<ChildProcess>(Command{fs::read_symlink("/proc/self/exe"), words}, environment_here(),
                                            fs::current_path(), log_file(study_.out, k))});
    }

    bool has_ended(Running& r) {
        const std::optional<Ended> end = r.child->poll();
        MemberState& state = states_[r.number] = read_member_state(state_file(study_.out, r.number));
        if (!end) return false;
        const Member& m = study_.members[r.number];
        if (!state.ended() && told_) {
            state.kind = Kind::stopped;  // before it had begun to listen
        } else if (!state.ended()) {     // it could not say more
            state.kind = Kind::failed;
            state.why = fmt::format(
                "{}; its output: {}",
                end->signal != 0 ? signal_in_words(end->signal) : fmt::format("ended with status {}", end->status),
                log_file(study_.out, r.number).string());
        }
        bar_.clear();
        if (state.kind == Kind::done)
            say(common_,
                m.name + ": " + closing_line(facts_of(m.method, read_record(m.folder / "record.h5"), m.folder)));
        else if (state.kind == Kind::failed)
            complain(m.name + ": failed: " + state.why);
        return true;
    }

    void show() {
        double made = 0;
        std::size_t ended = 0;
        for (std::size_t k = 0; k < states_.size(); ++k) {
            made += (states_[k].ended() ? 1 : states_[k].share) * study_.members[k].seconds;
            ended += states_[k].ended() ? 1 : 0;
        }
        std::string now;
        for (const Running& r : running_)
            now += fmt::format("{}{} {:.0f} %", now.empty() ? "" : ", ", study_.members[r.number].name,
                               100 * states_[r.number].share);
        const double share = ended == states_.size() ? 1 : made / work_, wall = wall_clock() - began_;
        bar_.show(share, wall, share > 0.01 ? wall * (1 - share) / share : 0,
                  fmt::format("{} of {} runs", ended, states_.size()), now);
    }

    const Study& study_;
    const int jobs_;
    const bool one_core_each_;
    const Common& common_;
    const int cores_ = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    std::vector<MemberState> states_;
    std::vector<std::size_t> queue_;
    std::vector<Running> running_;
    ProgressBar bar_;
    double work_ = 0;
    const double began_ = wall_clock();
    bool told_ = false;
};

}  // namespace

int share_of_cores(const std::vector<double>& waiting, int free) {
    const double all = std::accumulate(waiting.begin(), waiting.end(), 0.0);
    const int others = static_cast<int>(waiting.size()) - 1;
    const double part = all > 0 ? waiting.front() / all : 1.0 / static_cast<double>(waiting.size());
    return std::max(1, std::min(static_cast<int>(std::lround(part * free)), free - others));
}

double memory_for_jobs() { return 0.9 * machine_memory(); }

std::vector<MemberState> run_side_by_side(const Study& study, const Sharing& sharing, const Common& common) {
    if (study.members.empty()) return {};
    refuse_submitted(study.out);
    write_study(study);
    choose_passes();  // found once, before the members disturb each other
    return SideBySide(study, sharing, common).run();
}

}  // namespace tw::app

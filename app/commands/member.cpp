#include <fmt/format.h>

#include <chrono>

#include "app/arguments/output.h"
#include "app/campaign/campaign.h"
#include "app/progress/member_state.h"
#include "app/runs/ranks.h"
#include "app/study/study.h"
#include "app/terminal/command_words.h"
#include "app/terminal/stop_signal.h"
#include "base/errors.h"
#include "base/in_words.h"
#include "record/this_machine.h"
#include "sph_solver/parallel/comm.h"

namespace tw::app {
namespace {

/// Writes how far a run has come, once a second.
class Teller {
public:
    /// `speaks`: of the processes that share a run one alone writes.
    Teller(std::filesystem::path file, bool speaks) : file_(std::move(file)), speaks_(speaks) {
        state_.kind = MemberState::Kind::running;
        state_.node = host_name();
        write();
    }
    void progress(const Progress& p) {
        state_.share = p.duration > 0 ? p.time / p.duration : 0;
        state_.left = p.eta, state_.note = p.note;
        const auto now = std::chrono::steady_clock::now();
        if (now - told_ < std::chrono::seconds(1)) return;
        told_ = now;
        write();
    }
    void end(MemberState::Kind kind, const std::string& why = {}) {
        state_.kind = kind, state_.why = why;
        if (kind == MemberState::Kind::done) state_.share = 1;
        state_.left = 0;
        write();
    }

private:
    void write() const {
        if (speaks_) write_member_state(file_, state_);
    }

    std::filesystem::path file_;
    bool speaks_;
    MemberState state_;
    std::chrono::steady_clock::time_point told_;
};

}  // namespace

int run_member(const MemberCommand& command, const Common& common) {
    using State = CampaignResult::State;
    catch_stop_signals();
    const Study study = read_study(command.study);
    if (command.number >= study.members.size())
        throw InputError(command.study.string() + ": this study has " + std::to_string(study.members.size()) +
                         " runs, numbered from 0");
    const Member& member = study.members[command.number];
    const Comm& ranks = Comm::world();
    if (member.request.ranks > 1 && !ranks.many()) {
        const std::filesystem::path said = state_file(command.study, command.number);
        return run_on_ranks(member.request.ranks,
                            [&] { return read_member_state(said).kind == MemberState::Kind::done; });
    }
    if (member.request.ranks != ranks.size())
        throw InputError(fmt::format("{}: run {} is for {} processes, and {} were started", command.study.string(),
                                     command.number, member.request.ranks, ranks.size()));
    const std::filesystem::path file = std::filesystem::absolute(state_file(command.study, command.number));
    bool first = true;  // what was begun here is resumed
    ranks.together([&] { first = !std::filesystem::exists(file); });
    Teller teller(file, ranks.first());
    try {
        std::filesystem::current_path(study.where);
        RunRequest request = member.request;
        if (request.threads == 0) request.threads = command.threads;
        Common of_study = common;
        of_study.command = command_text(study.words);
        Campaign campaign(of_study, {.overwrite = first && study.overwrite,
                                     .take_finished = !first || study.take_finished,
                                     .progress = [&](const Progress& p) { teller.progress(p); }});
        const CampaignResult result =
            campaign.run_or_take({member.name, member.method, plan_run(request), member.folder});
        if (result.there()) return teller.end(MemberState::Kind::done), done;
        const bool stopped = result.state == State::stopped;
        teller.end(stopped ? MemberState::Kind::stopped : MemberState::Kind::failed, result.why_not);
        return stopped ? ended_early : run_failed;
    } catch (const InputError& e) {
        teller.end(MemberState::Kind::refused, e.what());
        throw;
    } catch (const std::exception& e) {
        teller.end(MemberState::Kind::failed, in_words(e));
        throw;
    }
}

}  // namespace tw::app

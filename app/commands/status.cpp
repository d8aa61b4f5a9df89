#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "app/arguments/output.h"
#include "app/cluster/slurm.h"
#include "app/cluster/submit.h"
#include "app/progress/member_state.h"
#include "app/progress/runs_status.h"
#include "app/study/study.h"
#include "app/terminal/terminal.h"
#include "base/errors.h"
#include "compare/report/escape.h"
#include "compare/report/numbers.h"
#include "compare/report/report_table.h"

namespace tw::app {
namespace {

namespace fs = std::filesystem;
using Kind = MemberState::Kind;

/// One run of a study as its files and Slurm see it.
struct StatusLine {
    std::string name, job, state = {}, remark = {};
    MemberState told = {};
};

class StudyStatus {
public:
    explicit StudyStatus(const fs::path& out)
        : out_(out), study_(read_study(out)), jobs_(read_jobs(out)), queued_(queued(jobs_)), ended_(accounted(jobs_)) {
        for (std::size_t k = 0; k < study_.members.size(); ++k) lines_.push_back(line(k));
    }

    std::string text() const {
        ReportTable t{"", {words("run"), words("state"), numbers("done", "%"), words("left"), words("job")}};
        std::size_t made = 0;
        for (const StatusLine& l : lines_) {
            made += l.told.kind == Kind::done ? 1 : 0;
            t.rows.push_back({{l.name, l.state, 100 * l.told.share,
                               l.told.left > 0 && !l.told.ended() ? time_text(l.told.left) : "", l.job},
                              l.remark});
        }
        std::string text = text_of(t) + fmt::format("{} of {} runs are done", made, lines_.size());
        if (!jobs_.empty()) text += "; report: job " + jobs_.back().id + ", " + of_slurm(jobs_.back().id);
        return text + "\n";
    }

    std::string json() const {
        nlohmann::ordered_json all = nlohmann::ordered_json::array();
        for (const StatusLine& l : lines_)
            all.push_back({{"name", l.name},
                           {"state", l.state},
                           {"share", l.told.share},
                           {"left", l.told.left},
                           {"note", l.told.note},
                           {"node", l.told.node},
                           {"job", l.job},
                           {"why", l.remark}});
        nlohmann::ordered_json facts = {{"folder", out_.string()}, {"runs", all}};
        facts["report"] = jobs_.empty() ? "" : of_slurm(jobs_.back().id);
        return facts.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    }

    double share() const {
        double made = 0;
        for (const StatusLine& l : lines_) made += l.told.ended() ? 1 : l.told.share;
        return lines_.empty() ? 1 : made / static_cast<double>(lines_.size());
    }
    bool all_done() const {
        return std::ranges::all_of(lines_, [](const StatusLine& l) { return l.told.kind == Kind::done; });
    }
    /// Nothing of it runs or waits any longer.
    bool over() const {
        return std::ranges::all_of(lines_, [](const StatusLine& l) { return l.told.ended() || l.state == "lost"; });
    }
    std::string states() const {
        std::string all;
        for (const StatusLine& l : lines_) all += l.state + ";";
        return all;
    }

private:
    /// What Slurm says of a job; "ended" where it has forgotten it.
    std::string of_slurm(const std::string& id) const {
        if (const auto found = queued_.find(id); found != queued_.end()) return found->second;
        if (const auto found = ended_.find(id); found != ended_.end()) return found->second;
        return "ended";
    }
    std::string job_of(std::size_t k) const {
        for (const SubmittedJob& job : jobs_)
            if (std::ranges::find(job.members, k) != job.members.end()) return fmt::format("{}_{}", job.id, k);
        return {};
    }

    /// Of a run that --jobs makes: whether its process is still there. Its own news may be older than the member's
    /// where it is resumed and being set up.
    static StatusLine of_this_machine(StatusLine l, const fs::path& state, const fs::path& run) {
        if (l.told.kind != Kind::running || !read_run_told(run).lost()) return l;
        std::error_code gone;
        const auto news = fs::last_write_time(state, gone) - fs::last_write_time(run / progress_file, gone);
        if (gone || news > std::chrono::seconds(5)) return l;
        l.state = "lost";
        l.remark = fmt::format("its process ended without a message at {:.0f} %; the same command continues from there",
                               100 * l.told.share);
        return l;
    }

    StatusLine line(std::size_t k) const {
        StatusLine l{study_.members[k].name, job_of(k)};
        l.told = read_member_state(state_file(out_, k));
        l.state = name_of(l.told.kind), l.remark = l.told.why;
        if (l.told.ended()) return l;
        if (l.job.empty())
            return of_this_machine(std::move(l), state_file(out_, k), study_.where / study_.members[k].folder);
        const bool alive = queued_.contains(l.job);
        const std::string slurm = of_slurm(l.job);
        l.job += ": " + slurm;
        if (alive) return l;
        l.state = "lost";
        l.remark = l.told.kind == Kind::waiting
                       ? fmt::format("its job ended without a message: can every node access {}?",
                                     fs::absolute(study_folder(out_) / "probe").string())
                       : fmt::format("its job ended at {:.0f} %; its output: {}; submit continues from there",
                                     100 * l.told.share, log_file(out_, k).string());
        return l;
    }

    fs::path out_;
    Study study_;
    std::vector<SubmittedJob> jobs_;
    std::map<std::string, std::string> queued_, ended_;
    std::vector<StatusLine> lines_;
};

/// Whether the runs in a folder are a study's that other processes or jobs make.
bool is_study(const fs::path& folder) {
    return fs::exists(study_folder(folder) / "study.json") && !fs::exists(folder / runs_list_file);
}

struct Look {
    std::string text, json, states;
    double share = 0;
    bool over = false, all_done = false;
};

template <class Status>
Look look(const Status& s) {
    return {s.text(), s.json(), s.states(), s.share(), s.over(), s.all_done()};
}
Look look_at(const fs::path& folder) { return is_study(folder) ? look(StudyStatus(folder)) : look(RunsStatus(folder)); }

/// Lines that fit a terminal, so that their number is known when they are written over.
std::string cut_to(const std::string& text, std::size_t columns, std::size_t& lines) {
    std::string all;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line); ++lines) all += fitted(line, columns) + "\n";
    return all;
}

}  // namespace

int run_status(const StudyCommand& command, const Common& common) {
    const Look now = look_at(command.folder);
    say(common, now.text);
    write_json(common, now.json);
    return done;
}

int run_watch(const WatchCommand& command, const Common& common) {
    const bool terminal = is_terminal(STDOUT_FILENO);
    std::size_t shown = 0;  // lines on the terminal
    std::string states;
    double share = -1;
    while (true) {
        const Look now = look_at(command.folder);
        const bool news = now.over || now.states != states || now.share >= share + 0.1;
        if (terminal) {
            const std::string back = shown > 0 ? fmt::format("\033[{}A\033[J", shown) : "";
            shown = 0;
            const std::string text = cut_to(for_terminal(now.text), terminal_columns(STDOUT_FILENO), shown);
            if (!common.quiet) std::fputs((back + text).c_str(), stdout), std::fflush(stdout);
        } else if (news) {  // in a log: where a run began or ended, and each tenth
            say(common, now.text);
            std::fflush(stdout);
            states = now.states, share = now.share;
        }
        if (now.over) return now.all_done ? done : run_failed;
        std::this_thread::sleep_for(std::chrono::duration<double>(command.every));
    }
}

int run_cancel(const StudyCommand& command, const Common& common) {
    const std::vector<SubmittedJob> jobs = read_jobs(command.folder);
    if (jobs.empty()) throw InputError(command.folder.string() + ": no jobs of this study have been submitted");
    write_file(study_folder(command.folder) / "cancelled", "no job of this study is put back into the queue\n");
    std::vector<std::string> ids;
    for (const SubmittedJob& job : jobs) ids.push_back(job.id);
    const SlurmAnswer answer = ask_slurm("scancel", ids);
    if (!answer.ok()) throw InputError("scancel refuses: " + answer.text);
    say(common, "cancelled: " + ids_of(jobs, ' ') + "; finished runs are kept, and submit continues from there\n");
    return done;
}

}  // namespace tw::app

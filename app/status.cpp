#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/member_state.h"
#include "app/output.h"
#include "app/slurm.h"
#include "app/study.h"
#include "app/submit.h"
#include "base/errors.h"
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

    StatusLine line(std::size_t k) const {
        StatusLine l{study_.members[k].name, job_of(k)};
        l.told = read_member_state(state_file(out_, k));
        l.state = name_of(l.told.kind), l.remark = l.told.why;
        if (l.job.empty() || l.told.ended()) return l;
        const bool alive = queued_.contains(l.job);
        const std::string slurm = of_slurm(l.job);
        l.job += ": " + slurm;
        if (alive) return l;
        l.state = "lost";
        l.remark = l.told.kind == Kind::waiting
                       ? fmt::format("its job ended without a word: does every node see {}?",
                                     fs::absolute(study_folder(out_) / "probe").string())
                       : fmt::format("its job ended at {:.0f} %; what it printed: {}; submit goes on from there",
                                     100 * l.told.share, log_file(out_, k).string());
        return l;
    }

    fs::path out_;
    Study study_;
    std::vector<SubmittedJob> jobs_;
    std::map<std::string, std::string> queued_, ended_;
    std::vector<StatusLine> lines_;
};

}  // namespace

int run_status(const StudyCommand& command, const Common& common) {
    const StudyStatus status(command.folder);
    say(common, status.text());
    write_json(common, status.json());
    return done;
}

int run_cancel(const StudyCommand& command, const Common& common) {
    const std::vector<SubmittedJob> jobs = read_jobs(command.folder);
    if (jobs.empty()) throw InputError(command.folder.string() + ": no jobs of this study have been submitted");
    write_file(study_folder(command.folder) / "cancelled", "no job of this study is put back into the queue\n");
    std::vector<std::string> ids;
    for (const SubmittedJob& job : jobs) ids.push_back(job.id);
    const SlurmAnswer answer = ask_slurm("scancel", ids);
    if (!answer.ok()) throw InputError("scancel refuses: " + answer.text);
    say(common, "cancelled: " + ids_of(jobs, ' ') + "; what is finished is kept, and submit goes on from there\n");
    return done;
}

}  // namespace tw::app

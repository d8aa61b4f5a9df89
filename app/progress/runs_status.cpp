#include "app/progress/runs_status.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/errors.h"
#include "compare/report/numbers.h"
#include "compare/report/report_table.h"
#include "text/plain_number.h"

namespace tw::app {
namespace {

namespace fs = std::filesystem;
using Kind = MemberState::Kind;

/// What a run has told; of one that has not told anything (made by an earlier program) what its record says.
RunTold told_in(const fs::path& folder) {
    RunTold told = read_run_told(folder);
    if (told.kind != Kind::waiting || !fs::exists(folder / "record.h5")) return told;
    try {
        const RunRecord record = read_record(folder / "record.h5");
        told.kind = record.state == "finished" ? Kind::done : record.state == "failed" ? Kind::failed : Kind::stopped;
        told.why = record.reason;
    } catch (const InputError& e) { told.why = e.what(); }
    return told;
}

/// The loads of a run that is under way, and what its checks say so far.
std::string details(const std::string& name, const RunTold& t) {
    std::string text = fmt::format("\n{}: t = {} of {} s, step {}, {} gone{}{}\n", name, plain_number(t.time, 4),
                                   plain_number(t.duration, 4), plain_number(t.steps), time_text(t.wall),
                                   t.note.empty() ? "" : ", ", t.note);
    for (const ForceTold& f : t.forces)
        text += fmt::format("  {}  {} {} now, mean since {} s: {}\n", f.name, plain_number(f.now, 4), f.unit,
                            plain_number(t.mean_from, 3),
                            std::isfinite(f.mean) ? plain_number(f.mean, 4) + " " + f.unit : "not begun");
    if (t.checks.empty()) return text;
    std::string not_met;
    for (const RecordedCheck& c : t.checks)
        if (!c.met())
            not_met +=
                fmt::format("; not met: {} {}{} (limit {}) at {} s", c.name, plain_number(c.value, 3),
                            c.unit == "-" ? "" : " " + c.unit, plain_number(c.limit, 3), plain_number(c.time, 3));
    const auto met = std::ranges::count_if(t.checks, [](const RecordedCheck& c) { return c.met(); });
    return text + fmt::format("  checks: {} of {} met so far{}\n", met, t.checks.size(), not_met);
}

}  // namespace

RunsStatus::RunsStatus(const fs::path& folder) : folder_(folder) {
    if (!fs::is_directory(folder))
        throw InputError(folder.string() + ": there is no such folder; expected one of a run or a study, as runs/demo");
    if (fs::exists(folder / runs_list_file))
        read_list();
    else
        find_runs();
    if (lines_.empty())
        throw InputError(folder.string() +
                         ": no run in it reports its progress; expected the folder of results of "
                         "`twinwake run`, `ladder`, `sweep` or `ablate`, or one of their runs");
}

void RunsStatus::read_list() {
    const RunsList list = read_runs_list(folder_);
    maker_ = list.maker, listed_ = list.told;
    for (const ListedRun& run : list.runs)
        lines_.push_back({run.name, folder_ / run.folder, run.seconds, told_in(folder_ / run.folder)});
    // what an earlier command left unfinished is still to be resumed
    for (Line& line : lines_)
        if (line.told.lost() && maker_.alive(listed_)) line.told.kind = Kind::waiting;
}

void RunsStatus::find_runs() {
    const auto take = [&](const fs::path& folder) {
        if (!fs::exists(folder / progress_file) && !fs::exists(folder / "record.h5")) return false;
        lines_.push_back({folder == folder_ ? folder.filename().string() : folder.lexically_relative(folder_).string(),
                          folder, 0, told_in(folder)});
        return true;
    };
    if (take(folder_)) return;
    for (auto entry = fs::recursive_directory_iterator(folder_, fs::directory_options::skip_permission_denied);
         entry != fs::recursive_directory_iterator(); ++entry)
        if (entry->is_directory() && (take(entry->path()) || entry.depth() > 4)) entry.disable_recursion_pending();
    std::ranges::sort(lines_, {}, &Line::name);
}

std::string RunsStatus::Line::state() const { return told.lost() ? "lost" : name_of(told.kind); }

std::string RunsStatus::Line::remark() const {
    if (!told.lost()) return told.why;
    return fmt::format(
        "its process ended without a message at {:.0f} %; the same command with --resume continues from there",
        100 * told.share());
}

double RunsStatus::share() const {
    double made = 0, all = 0;
    for (const Line& l : lines_) {
        const double weight = l.predicted > 0 ? l.predicted : 1;
        made += weight * (l.told.ended() ? 1 : l.told.share()), all += weight;
    }
    return all > 0 ? made / all : 0;
}

double RunsStatus::seconds_left() const {
    double left = 0;
    for (const Line& l : lines_) left += l.told.kind == Kind::waiting ? l.predicted : l.told.left;
    return left;
}

bool RunsStatus::over() const {
    if (std::ranges::any_of(lines_, [](const Line& l) { return l.told.kind == Kind::running && !l.told.lost(); }))
        return false;
    if (maker_.pid > 0) return !maker_.alive(listed_);
    return true;
}

bool RunsStatus::all_done() const {
    return std::ranges::all_of(lines_, [](const Line& l) { return l.told.kind == Kind::done; });
}

std::string RunsStatus::states() const {
    std::string all;
    for (const Line& l : lines_) all += l.state() + ";";
    return all;
}

std::string RunsStatus::text() const {
    ReportTable t{"", {words("run"), words("state"), numbers("done", "%"), words("left")}};
    std::string below;
    std::size_t made = 0;
    for (const Line& l : lines_) {
        made += l.told.kind == Kind::done ? 1 : 0;
        const bool runs = l.told.kind == Kind::running && !l.told.lost();
        t.rows.push_back({{l.name, l.state(), std::round(1000 * l.told.share()) / 10,
                           runs && l.told.left > 0 ? time_text(l.told.left) : ""},
                          l.remark()});
        if (runs || lines_.size() == 1) below += details(l.name, l.told);
    }
    const double left = over() ? 0 : seconds_left();
    return text_of(t) + below +
           fmt::format("\n{} of {} runs are done{}\n", made, lines_.size(),
                       left > 0 ? ", " + about_text(left) + " left" : "");
}

std::string RunsStatus::json() const {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const Line& l : lines_) {
        nlohmann::ordered_json run = nlohmann::ordered_json::parse(json_of(l.told));
        run["state"] = l.state(), run["why"] = l.remark();
        nlohmann::ordered_json named = {{"name", l.name}, {"folder", l.folder.string()}, {"predicted", l.predicted}};
        named.update(run);
        all.push_back(std::move(named));
    }
    const nlohmann::ordered_json facts = {{"folder", folder_.string()},
                                          {"over", over()},
                                          {"share", share()},
                                          {"left", over() ? 0 : seconds_left()},
                                          {"runs", all}};
    return facts.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace tw::app

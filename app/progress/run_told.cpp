#include "app/progress/run_told.h"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "base/errors.h"
#include "base/own_json.h"
#include "record/this_machine.h"

namespace tw::app {
namespace {

using ToldJson = nlohmann::ordered_json;
constexpr double most = 1e300, not_known = std::numeric_limits<double>::quiet_NaN();

ToldJson number_or_null(double v) { return std::isfinite(v) ? ToldJson(v) : ToldJson(nullptr); }
double number_or_nan(const nlohmann::json& from, const char* key) {
    return from.at(key).is_null() ? not_known : number_within(from, key, -most, most);
}

ProcessName process_in(const nlohmann::json& facts) {
    return {facts.at("node"), static_cast<long>(number_within(facts, "pid", 0, 1e12)), facts.at("begun")};
}

/// Field 22 of /proc/PID/stat, behind the name in brackets: clock ticks since the machine's start. Empty: no such
/// process.
std::string begun_of(long pid) {
    std::ifstream stat("/proc/" + std::to_string(pid) + "/stat");
    std::string text{std::istreambuf_iterator<char>(stat), {}};
    const std::size_t name_end = text.rfind(')');
    if (name_end == std::string::npos) return {};
    std::size_t at = name_end + 1;
    for (int field = 2; field < 22 && at != std::string::npos; ++field) at = text.find(' ', at) + 1;
    return text.substr(at, text.find(' ', at) - at);
}

}  // namespace

double seconds_since_1970() {
    return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

ProcessName ProcessName::own() { return {host_name(), ::getpid(), begun_of(::getpid())}; }

bool ProcessName::alive(double told) const {
    constexpr double silence = 600;  // meshing tells nothing for minutes [s]
    if (node != host_name()) return seconds_since_1970() - told < silence;
    return pid > 0 && !begun.empty() && begun_of(pid) == begun;
}

double RunTold::share() const {
    if (kind == MemberState::Kind::done) return 1;
    const double done = time / duration;
    return std::isfinite(done) ? std::clamp(done, 0.0, 1.0) : 0;
}

std::string json_of(const RunTold& t) {
    ToldJson forces = ToldJson::array(), checks = ToldJson::array();
    for (const ForceTold& f : t.forces)
        forces.push_back(
            {{"name", f.name}, {"unit", f.unit}, {"now", number_or_null(f.now)}, {"mean", number_or_null(f.mean)}});
    for (const RecordedCheck& c : t.checks)
        checks.push_back({{"name", c.name},
                          {"unit", c.unit},
                          {"value", number_or_null(c.value)},
                          {"limit", number_or_null(c.limit)},
                          {"time", number_or_null(c.time)},
                          {"met", c.met()}});
    const ToldJson all = {{"state", name_of(t.kind)},
                          {"method", t.method},
                          {"why", t.why},
                          {"note", t.note},
                          {"node", t.process.node},
                          {"pid", t.process.pid},
                          {"begun", t.process.begun},
                          {"told", t.told},
                          {"time", number_or_null(t.time)},
                          {"duration", number_or_null(t.duration)},
                          {"share", t.share()},
                          {"wall", number_or_null(t.wall)},
                          {"left", std::isfinite(t.left) ? t.left : 0},
                          {"steps", t.steps},
                          {"mean_from", number_or_null(t.mean_from)},
                          {"forces", forces},
                          {"checks", checks}};
    return all.dump(1, ' ', false, ToldJson::error_handler_t::replace) + "\n";
}

RunTold read_run_told(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / progress_file;
    if (!std::filesystem::exists(file)) return {};
    RunTold t;
    try {
        read_own_json(file, [&](const nlohmann::json& facts) {
            t.kind = kind_of_name(facts.at("state").get<std::string>());
            t.method = facts.at("method"), t.why = facts.at("why"), t.note = facts.at("note");
            t.process = process_in(facts);
            t.told = number_within(facts, "told", 0, 1e12), t.steps = number_within(facts, "steps", 0, 1e15);
            t.time = number_or_nan(facts, "time"), t.duration = number_or_nan(facts, "duration");
            t.wall = number_or_nan(facts, "wall"), t.left = number_within(facts, "left", 0, 1e12);
            t.mean_from = number_or_nan(facts, "mean_from");
            for (const nlohmann::json& f : facts.at("forces"))
                t.forces.push_back({f.at("name"), f.at("unit"), number_or_nan(f, "now"), number_or_nan(f, "mean")});
            for (const nlohmann::json& c : facts.at("checks")) {
                RecordedCheck line{c.at("name"), c.at("unit"), number_or_nan(c, "value"), number_or_nan(c, "limit")};
                line.time = number_or_nan(c, "time");
                t.checks.push_back(std::move(line));
            }
        });
    } catch (const InputError&) { return {}; }
    return t;
}

std::string json_of(const RunsList& l) {
    ToldJson runs = ToldJson::array();
    for (const ListedRun& r : l.runs)
        runs.push_back({{"name", r.name}, {"folder", r.folder.string()}, {"seconds", number_or_null(r.seconds)}});
    const ToldJson all = {
        {"node", l.maker.node}, {"pid", l.maker.pid}, {"begun", l.maker.begun}, {"told", l.told}, {"runs", runs}};
    return all.dump(1, ' ', false, ToldJson::error_handler_t::replace) + "\n";
}

RunsList read_runs_list(const std::filesystem::path& out) {
    RunsList l;
    read_own_json(out / runs_list_file, [&](const nlohmann::json& facts) {
        l.maker = process_in(facts);
        l.told = number_within(facts, "told", 0, 1e12);
        for (const nlohmann::json& run : facts.at("runs"))
            l.runs.push_back(
                {run.at("name"), run.at("folder").get<std::string>(), number_within(run, "seconds", 0, 1e12)});
    });
    return l;
}

}  // namespace tw::app

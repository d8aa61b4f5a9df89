#include "app/cluster/submit.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/arguments/output.h"
#include "app/cluster/job_scripts.h"
#include "app/cluster/slurm.h"
#include "app/terminal/command_words.h"
#include "base/atomic_file.h"
#include "base/errors.h"
#include "compare/report/escape.h"
#include "compare/report/numbers.h"
#include "compare/report/report_table.h"
#include "scene/cost/node.h"

namespace tw::app {
namespace {

namespace fs = std::filesystem;

std::string first_line(const std::string& file) {
    std::istringstream text(read_text(file));
    std::string line;
    std::getline(text, line);
    return line;
}

/// Slurm's words without line ends.
std::string in_one_line(std::string words) {
    while (!words.empty() && words.back() == '\n') words.pop_back();
    std::ranges::replace(words, '\n', ' ');
    return words;
}

/// The number in what `sbatch --parsable` says: "12" or "12;cluster", behind any warnings.
std::string id_in(const std::string& text) {
    std::istringstream lines(text);
    std::string id;
    for (std::string line; std::getline(lines, line);)
        if (const std::string word = line.substr(0, line.find(';'));
            !word.empty() && word.find_first_not_of("0123456789") == word.npos)
            id = word;
    return id;
}

class Submission {
public:
    Submission(Study study, const SubmitOptions& options, const Common& common)
        : study_(std::move(study)),
          common_(common),
          dry_run_(options.dry_run),
          site_(completed(options.site, options.site_file)),
          folder_(fs::absolute(study_folder(study_.out)).lexically_normal()) {}

    int run() {
        if (study_.members.empty())
            throw InputError(study_.out.string() +
                             ": every run is finished; the same command with --collect makes the report");
        if (!dry_run_ && !slurm_has("sbatch")) ask_slurm("sbatch", {});  // says that it is not there
        make_folder(folder_);
        refuse_submitted(study_.out);
        write_all();
        say(common_, table());
        if (dry_run_) return tell();
        look_for_disk();
        submit();
        write_jobs(study_.out, jobs_);
        say(common_, fmt::format("submitted: {}; twinwake status {} shows how far they are\n", ids_of(jobs_, ' '),
                                 shell_file(study_.out.string())));
        write_json(common_, facts());
        return done;
    }

private:
    void write_all() {
        study_.where = fs::current_path();
        for (Member& m : study_.members) {  // time and memory on the cores that it will have
            m.request.threads = cores_of_rank(m, site_.cores);
            const PlannedRun on_nodes = plan_run(m.request);
            m.seconds = on_nodes.seconds(m.method);
            const Prediction& p = on_nodes.prediction;
            if (m.request.ranks > 1)  // of the first, which has the raster
                m.bytes = p.raster_bytes + bytes_on({}, on_nodes.scene, p.of(m.method), p.raster_bytes);
        }
        write_study(study_);
        for (const char* old : {"cancelled", "jobs.json"}) fs::remove(folder_ / old);
        arrays_ = arrays_of(study_, site_);
        probe_ = dry_run_ ? "a word that submit writes" : first_line("/proc/sys/kernel/random/uuid");
        write_file(folder_ / "probe", probe_ + "\n");
        const std::string program = fs::read_symlink("/proc/self/exe");
        double bytes = 2e9;
        for (const JobArray& a : arrays_) {
            write_file(script_of(a), array_script(a, site_, program, probe_));
            bytes = std::max(bytes, a.bytes);
        }
        write_file(folder_ / "report.sbatch", report_script(study_, site_, program, bytes));
    }

    fs::path script_of(const JobArray& a) const { return folder_ / (a.name() + ".sbatch"); }

    std::string table() const {
        ReportTable t{"", {words("jobs"), numbers("runs"), numbers("cores"), words("time"), numbers("memory", "GB")}};
        for (const JobArray& a : arrays_)
            t.rows.push_back(
                {{a.name(), a.members.size(), a.ranks * a.cores, slurm_time(a.seconds), a.ranks * a.bytes / 1e9}});
        return fmt::format("{}Asked for: {} times the predicted time of the longest and {}, {} times its memory.\n",
                           text_of(t), margin_of_time, time_text(least_time), margin_of_memory);
    }

    std::vector<std::string> words_for(const fs::path& script) const {
        return {"--parsable", "--chdir=" + folder_.string(), script.string()};
    }
    std::vector<std::string> words_for_report(const std::string& ids) const {
        std::vector<std::string> arguments = words_for(folder_ / "report.sbatch");
        arguments.insert(arguments.begin() + 1, "--dependency=afterany:" + ids);
        return arguments;
    }

    /// What would be submitted, and what Slurm thinks of it where it is there.
    int tell() {
        std::string text = "not submitted (--dry-run):\n", ids;
        const auto line = [&](const std::vector<std::string>& arguments) {
            text += "  sbatch";
            for (const std::string& word : arguments) text += " " + shell_word(word);
            text += "\n";
        };
        for (const JobArray& a : arrays_) {
            line(words_for(script_of(a)));
            ids += (ids.empty() ? "" : ":") + a.name();
        }
        line(words_for_report(ids));
        say(common_, text);
        if (slurm_has("sbatch")) ask_for_opinion();
        write_json(common_, facts());
        return done;
    }

    /// What `sbatch --test-only` says of each script. A Slurm whose controller does not answer has no opinion.
    void ask_for_opinion() const {
        if (slurm_has("scontrol"))
            if (const SlurmAnswer ping = ask_slurm("scontrol", {"ping"}); !ping.ok()) {
                say(common_, "not tested by Slurm, whose controller does not answer: " + in_one_line(ping.text) + "\n");
                return;
            }
        for (const JobArray& a : arrays_) {
            std::vector<std::string> arguments = words_for(script_of(a));
            arguments.front() = "--test-only";
            const SlurmAnswer answer = ask_slurm("sbatch", arguments);
            say(common_, a.name() + ": " + in_one_line(answer.text) + "\n");
            if (!answer.ok()) throw InputError("sbatch --test-only refuses: " + in_one_line(answer.text));
        }
    }

    /// Asks a node, if one is free, whether it sees the probe.
    void look_for_disk() const {
        if (!slurm_has("srun")) return;
        std::vector<std::string> arguments{"--immediate=5", "--quiet",   "--nodes=1",   "--ntasks=1",
                                           "--time=1",      "--chdir=/", "--input=none"};
        for (const auto& [option, value] :
             {std::pair("account", site_.account), {"partition", site_.partition}, {"qos", site_.qos}})
            if (!value.empty()) arguments.push_back(fmt::format("--{}={}", option, value));
        const fs::path probe = folder_ / "probe";
        arguments.insert(arguments.end(), {"/bin/cat", probe.string()});
        const SlurmAnswer answer = ask_slurm("srun", arguments);
        if (answer.ok() && answer.text.find(probe_) == answer.text.npos) refuse_disk(probe);
        if (answer.text.find("/bin/cat: ") != answer.text.npos) refuse_disk(probe);  // it ran and did not find it
    }
    [[noreturn]] static void refuse_disk(const fs::path& probe) {
        throw InputError(probe.string() +
                         ": a node of the cluster cannot access this file, so the folder is on a disk that the nodes "
                         "do not share; choose a shared one with --out");
    }

    void submit() {
        for (const JobArray& a : arrays_) jobs_.push_back({sbatch(words_for(script_of(a))), a.members});
        jobs_.push_back({sbatch(words_for_report(ids_of(jobs_, ':')))});
    }
    std::string sbatch(const std::vector<std::string>& arguments) {
        const SlurmAnswer answer = ask_slurm("sbatch", arguments);
        const std::string id = id_in(answer.text);
        if (answer.ok() && !id.empty()) return id;
        if (!jobs_.empty()) ask_slurm("scancel", {ids_of(jobs_, ' ')});  // all of it or nothing
        throw InputError(fmt::format("Slurm refuses {}: {}", arguments.back(), in_one_line(answer.text)));
    }

    std::string facts() const {
        nlohmann::ordered_json json = {{"folder", study_.out.string()}, {"submitted", !dry_run_}};
        json["arrays"] = nlohmann::ordered_json::array();
        for (std::size_t k = 0; k < arrays_.size(); ++k)
            json["arrays"].push_back({{"name", arrays_[k].name()},
                                      {"members", arrays_[k].members},
                                      {"ranks", arrays_[k].ranks},
                                      {"cores", arrays_[k].cores},
                                      {"seconds", arrays_[k].seconds},
                                      {"bytes", arrays_[k].bytes},
                                      {"job", jobs_.empty() ? "" : jobs_[k].id}});
        json["report"] = jobs_.empty() ? "" : jobs_.back().id;
        return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    }

    Study study_;
    const Common& common_;
    const bool dry_run_;
    const Site site_;
    const fs::path folder_;
    std::string probe_;
    std::vector<JobArray> arrays_;
    std::vector<SubmittedJob> jobs_;
};

}  // namespace

int submit_study(Study study, const SubmitOptions& options, const Common& common) {
    return Submission(std::move(study), options, common).run();
}

Common common_of_study(const SubmitOptions& options, const Common& common) {
    Common of_study = common;
    std::map<std::string, int> own = options.own;
    own["--json"] = 1;
    of_study.words = without_options({common.words.begin() + 1, common.words.end()}, own);
    of_study.command = command_text(of_study.words);
    return of_study;
}

}  // namespace tw::app

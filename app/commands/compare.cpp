#include "compare/compare.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <optional>

#include "app/arguments/output.h"
#include "app/campaign/grid_study_jobs.h"
#include "app/campaign/write_grid_study.h"
#include "app/runs/read_run.h"
#include "base/errors.h"
#include "base/folder_lock.h"
#include "compare/grid_study/grid_study_report.h"
#include "compare/grid_study/judge_by_sizes.h"
#include "compare/reports/two_reports.h"
#include "methods/methods.h"
#include "record/wave_twin.h"

namespace tw::app {
namespace {

namespace fs = std::filesystem;

bool is_methods_folder(const fs::path& source) { return fs::exists(source / "record.h5"); }

/// The record files that a name stands for: the file itself, a method's folder, or a run's folder with all its methods
/// in it.
std::vector<fs::path> record_files(const fs::path& source) {
    if (!fs::is_directory(source)) return {source};
    if (is_methods_folder(source)) return {source / "record.h5"};
    std::vector<fs::path> files;
    for (const std::string& method : method_names())
        if (fs::exists(source / method / "record.h5")) files.push_back(source / method / "record.h5");
    if (files.empty())
        throw InputError(
            fmt::format("{}: no run record here; expected record.h5, {}/record.h5 (twinwake run leaves them)",
                        source.string(), fmt::join(method_names(), "/record.h5 or ")));
    return files;
}

/// Records in the folders below one: of sizes, their variations and methods.
std::vector<fs::path> files_below(const fs::path& folder) {
    std::vector<fs::path> files;
    if (!fs::is_directory(folder)) return files;
    constexpr int deepest = 3;  // size, a variation, method: behind it lie cases
    for (fs::recursive_directory_iterator at(folder), end; at != end; ++at) {
        if (at->path().filename() == empty_twins_folder || at->path().filename() == calm_twins_folder)
            at.disable_recursion_pending();  // read_run finds them
        if (at->path().filename() == "record.h5") files.push_back(at->path());
        if (at.depth() >= deepest || at->path().filename() == "case") at.disable_recursion_pending();
    }
    std::ranges::sort(files);
    return files;
}

/// The coarser runs that `twinwake run` left beside a run's records; none where the source is no run's folder.
std::vector<fs::path> coarser_files(const fs::path& source) {
    return is_methods_folder(source) ? std::vector<fs::path>() : files_below(source / "twins");
}

/// The runs that `twinwake ladder` left in its folder; none where the source is a run's.
std::vector<fs::path> files_of_sizes(const fs::path& source) {
    const auto is_of_run = [&](const std::string& method) { return fs::exists(source / method / "record.h5"); };
    if (is_methods_folder(source) || std::ranges::any_of(method_names(), is_of_run)) return {};
    return files_below(source);
}

void take_finished(GridStudyHarvest& harvest, const std::vector<fs::path>& files) {
    for (const fs::path& file : files) {
        RunRecord record = read_run(file);
        if (record.state != "finished") continue;
        harvest.take(std::move(record), file);
        if (std::optional<GridStudyVariation> input = uncertain_input_of(file, harvest.runs.back())) {
            harvest.variations.push_back(std::move(*input));
            harvest.runs.pop_back();
        }
    }
}

/// Runs that differ from others of their size in a choice.
void part_variations(GridStudyHarvest& harvest) {
    std::ranges::move(take_variations(harvest.runs), std::back_inserter(harvest.variations));
}

/// What a run's folder says of the discretisation error, as its own report does; none: nothing in it, or no grid study.
std::optional<GridStudy> grid_study_of_coarser_members(const CompareCommand& command) {
    if (command.sources.size() != 1) return {};
    const std::vector<fs::path> coarser_members = coarser_files(command.sources.front());
    if (coarser_members.empty()) return {};
    GridStudyHarvest harvest;
    for (const fs::path& file : record_files(command.sources.front())) harvest.take(read_run(file), file);
    take_finished(harvest, coarser_members);
    part_variations(harvest);
    harvest.drop_lone_variations();
    try {
        return grid_study_of(harvest);
    } catch (const InputError& e) {  // the records are there: they are compared all the same
        complain(std::string("coarser runs (twins): no discretisation error: ") + e.what());
        return {};
    }
}

int compare_grid_study(const CompareCommand& command, const Common& common) {
    if (command.out.empty())
        throw InputError("compare --ladder: expected --out, a folder for the tables and the report");
    GridStudyHarvest harvest;
    for (const fs::path& source : command.sources) {
        if (const std::vector<fs::path> sizes = files_of_sizes(source); !sizes.empty()) {
            take_finished(harvest, sizes);
            continue;
        }
        for (const fs::path& file : record_files(source)) harvest.take(read_run(file), file);
        take_finished(harvest, coarser_files(source));
    }
    part_variations(harvest);
    const FolderLock lock(command.out);
    const GridStudy grid_study = report_grid_study(harvest, measured_records(command.measured), command.out, common);
    if (!command.require_agree) return done;
    const std::string others = not_agreeing(grid_study);
    if (others.empty()) return done;
    complain("--require agree is not met: " + others);
    return not_agreed;
}

bool is_report(const fs::path& source) { return source.extension() == ".json"; }

/// Two report.json files: what their runs say otherwise.
int compare_two_reports(const CompareCommand& command, const Common& common) {
    if (command.sources.size() != 2 || !std::ranges::all_of(command.sources, is_report))
        throw InputError(
            fmt::format("compare: {} is a report, and the command has {} sources; expected two reports (A/report.json "
                        "B/report.json), or records only",
                        std::ranges::find_if(command.sources, is_report)->string(), command.sources.size()));
    for (const auto& [given, option] : {std::pair{!command.out.empty(), "--out"},
                                        {command.grid_study, "--ladder"},
                                        {!command.measured.empty(), "--measured"},
                                        {command.force, "--force"},
                                        {command.require_agree, "--require"}})
        if (given)
            throw InputError(
                fmt::format("compare: {} is for records; two reports are compared on the terminal, and with --json "
                            "FILE as facts",
                            option));
    const TwoReports reports = compare_reports(read_report(command.sources[0]), read_report(command.sources[1]));
    say(common, text_of(reports));
    write_json(common, json_of(reports));
    return done;
}

}  // namespace

int run_compare(const CompareCommand& command, const Common& common) {
    if (std::ranges::any_of(command.sources, is_report)) return compare_two_reports(command, common);
    if (command.grid_study) return compare_grid_study(command, common);
    std::vector<RunRecord> records;
    for (const fs::path& source : command.sources)
        for (const fs::path& file : record_files(source)) records.push_back(read_run(file));
    CompareOptions options;
    options.force = command.force;
    Comparison comparison = compare_records(std::move(records), options);
    const std::optional<GridStudy> grid_study = grid_study_of_coarser_members(command);
    if (grid_study) judge_by_sizes(comparison, *grid_study);
    std::string text = summary_text(comparison);
    std::optional<FolderLock> lock;  // a run may be writing its own report there
    if (!command.out.empty()) lock.emplace(command.out);
    if (lock)
        text += "\nreport: " + leaving_files([&] {
                                   return write_report(comparison, command.out,
                                                       grid_study ? grid_study_html(*grid_study) : "");
                               }).html.string() +
                "\n";
    say(common, text);
    write_json(common, comparison_json(comparison));
    if (!command.require_agree) return done;
    if (grid_study) {
        const std::string others = not_agreeing(*grid_study);
        if (others.empty()) return done;
        complain("--require agree is not met: " + others);
        return not_agreed;
    }
    complain(
        "--require agree cannot be met by runs of one size: their discretisation error is not estimated. Run the scene "
        "at several sizes with twinwake ladder, or give the records of such runs to twinwake compare --ladder");
    return not_agreed;
}

}  // namespace tw::app

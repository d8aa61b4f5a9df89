#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <set>

#include "base/errors.h"
#include "foam_cases/read/number_rows.h"
#include "foam_cases/read/step_loads.h"
#include "import/readers.h"

namespace tw {
namespace {

namespace fs = std::filesystem;

constexpr std::array file_names{"force.dat", "moment.dat", "forces.dat"};

/// Names of what lies in a folder, sorted: "forces, probes"; "nothing" where there is nothing.
std::string listing(const fs::path& folder) {
    std::set<std::string> names;
    std::error_code none;
    for (const auto& e : fs::directory_iterator(folder, none)) names.insert(e.path().filename().string());
    std::string list;
    for (const std::string& n : names) {
        if (list.size() > 400) return list + ", ...";
        list += (list.empty() ? "" : ", ") + n;
    }
    return list.empty() ? "nothing" : list;
}

/// What the comment lines at the head of one file say.
struct Head {
    bool comment = false;        ///< there is one, as the function object writes
    std::optional<Vec3> centre;  ///< "# CofR : (x y z)", in the case's axes [m]
};
Head head_of(const fs::path& file) {
    Head head;
    std::ifstream in(file, std::ios::binary);
    std::string line;
    for (int n = 0; n < 30 && std::getline(in, line) && line.starts_with('#'); ++n) {
        head.comment = true;
        const std::size_t at = line.find("CofR");
        if (at == std::string::npos) continue;
        const std::vector<double> numbers = numbers_in(std::string_view(line).substr(at + 4));
        if (numbers.size() == 3) head.centre = Vec3(numbers[0], numbers[1], numbers[2]);
    }
    return head;
}

/// Looks at every file that will be read: each must be one of the function object. Returns the centre of rotation they
/// share, if they say it.
std::optional<Vec3> check_files(const fs::path& folder, const std::string& place) {
    std::optional<Vec3> centre;
    bool any = false;
    for (const char* name : file_names) {
        for (const auto& [start, file] : segments(folder, name)) {
            any = true;
            const Head head = head_of(file);
            if (!head.comment)
                throw InputError(file.string() +
                                 ":1: no comment line found; expected a file of the forces function "
                                 "object, which begins with #");
            if (centre && head.centre && *centre != *head.centre)
                throw InputError(
                    fmt::format("{}: the start-time folders of {} have different centres of rotation "
                                "(CofR); expected one; remove the older folders",
                                place, folder.string()));
            if (head.centre) centre = head.centre;
        }
    }
    if (!any)
        throw InputError(
            fmt::format("{}: no start-time folder of {} holds force.dat and moment.dat, or forces.dat; "
                        "found there: {}",
                        place, folder.string(), listing(folder)));
    return centre;
}

/// Forces and moments are written together: but for the row that was being written, each has the other's times.
void refuse_unmatched_rows(const fs::path& folder, const StepLoads& loads, const std::string& place) {
    if (segments(folder, "force.dat").empty()) return;  // one file has both
    for (const char* name : {"force.dat", "moment.dat"}) {
        const auto rows = joined_rows(folder, name);
        const auto until_last = std::ranges::count_if(rows, [&](const auto& r) { return r[0] <= loads.time.back(); });
        const std::size_t matched = loads.time.size();
        if (static_cast<std::size_t>(until_last) == matched && rows.size() <= matched + 1) continue;
        throw InputError(fmt::format(
            "{}: {} has {} rows, and {} of them have a row of the same time in {}; expected both files "
            "whole: copy them again",
            place, name, rows.size(), matched, name == std::string_view("force.dat") ? "moment.dat" : "force.dat"));
    }
}

/// What a run that blew up leaves, and no number of a flow.
void refuse_no_numbers(const fs::path& folder, const StepLoads& loads, const std::string& place) {
    for (std::size_t i = 0; i < loads.time.size(); ++i)
        for (const auto* of : {&loads.pressure, &loads.viscous})
            for (const double v : (*of)[i])
                if (!std::isfinite(v))
                    throw InputError(
                        fmt::format("{}: the loads in {} are {} at t = {:.6g} s; expected finite numbers. Did the run "
                                    "blow up? Cut it off before that time",
                                    place, folder.string(), v, loads.time[i]));
}

}  // namespace

MomentPoint read_openfoam(const Mapping& mapping, RunRecord& record) {
    const fs::path post = mapping.source / "postProcessing", folder = post / mapping.function_object;
    const auto named = mapping.place.find("function_object");
    const std::string place = named != mapping.place.end() ? named->second : mapping.place.at("source");
    std::error_code none;
    if (!fs::is_directory(folder, none))
        throw InputError(fmt::format("{}: there is no folder {}; {} holds: {}; expected function_object = one of them",
                                     place, folder.string(), post.string(), listing(post)));
    const std::optional<Vec3> centre = check_files(folder, place);
    const StepLoads loads = read_loads(folder);
    if (loads.time.empty())
        throw InputError(
            fmt::format("{}: the force files in {} hold no whole row yet; expected rows of time, pressure "
                        "and viscous parts",
                        place, folder.string()));
    refuse_unmatched_rows(folder, loads, place);
    refuse_no_numbers(folder, loads, place);

    Table& t = record.table("forces");
    t.time = loads.time;
    const auto add = [&](const char* name, const char* unit, Eigen::Index axis, bool pressure, bool viscous) {
        std::vector<double>& values = t.column(name, unit).values;
        const std::size_t first = std::string_view(unit) == "N" ? 0 : 3;
        const auto vector = [&](const std::array<double, 6>& l) { return Vec3(l[first], l[first + 1], l[first + 2]); };
        for (std::size_t i = 0; i < loads.time.size(); ++i) {
            Vec3 load = Vec3::Zero();
            if (pressure) load += vector(loads.pressure[i]);
            if (viscous) load += vector(loads.viscous[i]);
            values.push_back(mapping.axes.row(axis).dot(load) + 0.0);
        }
    };
    add("fx", "N", 0, true, true);
    add("fy", "N", 1, true, true);
    add("fz", "N", 2, true, true);
    add("fx_pressure", "N", 0, true, false);
    add("fz_pressure", "N", 2, true, false);
    add("fx_viscous", "N", 0, false, true);
    add("fz_viscous", "N", 2, false, true);
    if (mapping.moment_point) {
        add("my", "N m", 1, true, true);
        return mapping.moment_point;
    }
    if (!centre) return {};  // a moment about an unknown point is none
    add("my", "N m", 1, true, true);
    return mapping.axes * *centre;
}

}  // namespace tw

#include "foam_cases/run/watchdog.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

#include "foam_cases/read/number_rows.h"

namespace tw {
namespace fs = std::filesystem;

std::optional<std::string> trouble(const SolverLog& log, double largest_speed, const Limits& limits) {
    const auto& steps = log.steps();
    if (steps.empty()) return std::nullopt;
    const SolverLog::Step& last = steps.back();
    if (last.step > 0 && last.step < limits.smallest_step)
        return fmt::format(
            "the time step collapsed to {:.2g} s at t = {:.4g} s: the flow has become unstable somewhere, often at a "
            "bad "
            "cell of the mesh (see log.checkMesh) or a sharp edge that is too coarse for max_courant",
            last.step, last.time);
    const auto count = static_cast<std::ptrdiff_t>(limits.collapsed_steps);
    if (static_cast<std::ptrdiff_t>(steps.size()) > 3 * count) {
        std::vector<double> sizes;
        for (const auto& s : steps) sizes.push_back(s.step);
        std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2), sizes.end());
        const double usual = sizes[sizes.size() / 2];
        if (std::all_of(steps.end() - count, steps.end(),
                        [&](const auto& s) { return s.step < limits.collapse * usual; }))
            return fmt::format(
                "the time step has been below {:g} of its usual {:.2g} s for {} steps at t = {:.4g} s: the run would "
                "not end; "
                "the flow has become unstable, often at a bad cell of the mesh (see log.checkMesh)",
                limits.collapse, usual, limits.collapsed_steps, last.time);
    }
    const double speed = limits.speed * (last.time < limits.start_up ? 10 : 1);
    if (largest_speed > speed)
        return fmt::format(
            "velocity reached {:.4g} m/s at t = {:.4g} s, more than the {:.4g} m/s that this scene can explain: the "
            "flow has "
            "become unstable, most often in the air at a sharp edge; a smaller max_courant or near_hull helps",
            largest_speed, last.time, speed);
    if (std::isnan(last.water) && last.cpu > 0 && steps.size() > 2)
        return fmt::format("the water's volume is no number at t = {:.4g} s: the flow has become unstable", last.time);
    return std::nullopt;
}

double latest_fastest(const fs::path& post_processing, double now) {
    std::vector<Segment> starts = segments(post_processing / "fastest", "fieldMinMax.dat");
    if (starts.empty()) starts = segments(post_processing / "fastest", "volFieldValue.dat");
    if (starts.empty()) return std::numeric_limits<double>::quiet_NaN();
    std::ifstream in(starts.back().file, std::ios::binary);
    if (!in) return std::numeric_limits<double>::quiet_NaN();
    in.seekg(0, std::ios::end);
    const auto size = static_cast<long long>(in.tellg());
    in.seekg(std::max(0LL, size - 2000));
    std::string line, last;
    std::getline(in, line);  // cut off, or the header
    while (std::getline(in, line) && !in.eof()) last = line;
    const std::vector<double> all = last.starts_with('#') ? std::vector<double>{} : numbers_in(last);
    if (all.size() < 2 || all.front() > now * (1 + time_name_precision))
        return std::numeric_limits<double>::quiet_NaN();
    // volFieldValue: time, max. fieldMinMax: time, mag(U), min, (x y z), [processor,] max, (x y z) [, processor]: the
    // largest stands before the last place
    const std::size_t place = last.rfind('('), earlier = place == std::string::npos ? place : last.rfind(')', place);
    if (place == std::string::npos) return all.back();
    if (earlier == std::string::npos) return std::numeric_limits<double>::quiet_NaN();
    const std::vector<double> between = numbers_in(std::string_view(last).substr(earlier, place - earlier));
    return between.empty() ? std::numeric_limits<double>::quiet_NaN() : between.back();
}

std::optional<std::string> disk_trouble(const fs::path& folder, double needed) {
    std::error_code error;
    const fs::space_info space = fs::space(folder, error);
    if (error || static_cast<double>(space.available) >= needed) return std::nullopt;
    return fmt::format(
        "{}: the disk is full: {:.1f} MB are free, {:.1f} MB are needed; free some space and go on with --resume",
        folder.string(), 1e-6 * static_cast<double>(space.available), 1e-6 * needed);
}

}  // namespace tw

#include "foam_cases/run/watchdog.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

#include "foam_cases/read/frame_reader.h"
#include "foam_cases/read/number_rows.h"
#include "record/recorded_checks.h"

namespace tw {
namespace fs = std::filesystem;

namespace {

using Steps = std::vector<SolverLog::Step>;

std::optional<std::string> collapsed_step(const Steps& steps, const Limits& limits) {
    const SolverLog::Step& last = steps.back();
    if (last.step > 0 && last.step < limits.smallest_step)
        return fmt::format(
            "the time step collapsed to {:.2g} s at t = {:.4g} s: the flow has become unstable somewhere, often at a "
            "bad cell of the mesh (see log.checkMesh) or a sharp edge that is too coarse for max_courant",
            last.step, last.time);
    const auto count = static_cast<std::ptrdiff_t>(limits.collapsed_steps);
    if (static_cast<std::ptrdiff_t>(steps.size()) <= 3 * count) return {};
    std::vector<double> sizes;
    for (const auto& s : steps) sizes.push_back(s.step);
    std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2), sizes.end());
    const double usual = sizes[sizes.size() / 2];
    if (!std::all_of(steps.end() - count, steps.end(), [&](const auto& s) { return s.step < limits.collapse * usual; }))
        return {};
    return fmt::format(
        "the time step has been below {:g} of its usual {:.2g} s for {} steps at t = {:.4g} s: the run would not end; "
        "the flow has become unstable, often at a bad cell of the mesh (see log.checkMesh)",
        limits.collapse, usual, limits.collapsed_steps, last.time);
}

/// Water that comes from nowhere, goes nowhere, or is more than a cell can hold.
std::optional<std::string> wrong_volume(const Steps& steps, const Limits& limits) {
    const SolverLog::Step& last = steps.back();
    const bool solved = last.cpu > 0;  // to its end: the water is known
    if (std::isnan(last.water) && solved && steps.size() > 2)
        return fmt::format("the water's volume is no number at t = {:.4g} s: the flow has become unstable", last.time);
    if (!solved) return {};
    const double change = last.water / steps.front().water - 1;
    if ((limits.gains_no_water && change > limits.water) || (limits.loses_no_water && change < -limits.water))
        return fmt::format(
            "the tank's water has become {:.3g} % {} by t = {:.4g} s, and none can {}: the flow has become unstable; a "
            "smaller max_alpha_courant helps",
            100 * std::abs(change), change > 0 ? "more" : "less", last.time, change > 0 ? "come in" : "leave");
    if (std::abs(change) > limits.stream_water)
        return fmt::format(
            "the box of the stream holds {:.3g} % {} water than at its start at t = {:.4g} s: {} comes in than leaves, "
            "and the ends do not hold the level; forcing_zones = \"on\" in [effects], a longer box, or a stream that "
            "the "
            "depth can carry helps",
            100 * std::abs(change), change > 0 ? "more" : "less", last.time, change > 0 ? "more" : "less");
    if (last.least < -limits.fraction || last.most > 1 + limits.fraction)
        return fmt::format(
            "a cell's water fraction reached {:.3g} at t = {:.4g} s, where it is 0 to 1: the flow has become unstable; "
            "a smaller max_alpha_courant helps",
            last.most > 1 + limits.fraction ? last.most : last.least, last.time);
    if (last.continuity > limits.continuity)
        return fmt::format(
            "the flow creates or loses {:.2g} of the domain's volume in the step at t = {:.4g} s, where the limit is "
            "{:g}: its pressure is not solved, most often at a bad cell of the mesh (see log.checkMesh)",
            last.continuity, last.time, limits.continuity);
    return {};
}

}  // namespace

Limits limits_of(const CasePlan& plan) {
    const Scene& scene = *plan.scene;
    Limits limits;
    limits.smallest_step = std::min(1e-8, 1e-4 * plan.first_step);
    limits.water_speed = plan.water_speed_limit;
    limits.air_speed = plan.air_speed_limit;
    limits.gains_no_water = scene.motion.kind == Motion::Kind::none && !plan.mesh_motion.whole_mesh();
    if (plan.stream && !plan.mesh_motion.whole_mesh()) limits.stream_water = 0.5;
    limits.loses_no_water = limits.gains_no_water &&
                            std::ranges::none_of(plan.sides, [](const Patch& p) { return p.side == Side::atmosphere; });
    // a body or a tank that moves does work on the water
    if (plan.mesh_moves() || scene.tank_motion) limits.energy_made = std::numeric_limits<double>::infinity();
    return limits;
}

std::optional<std::string> trouble(const SolverLog& log, double largest_speed, const Limits& limits) {
    const Steps& steps = log.steps();
    if (steps.empty()) return std::nullopt;
    if (auto wrong = collapsed_step(steps, limits)) return wrong;
    if (largest_speed > limits.air_speed)
        return fmt::format(
            "velocity reached {:.4g} m/s at t = {:.4g} s, more than the {:.4g} m/s that air can have in the narrowest "
            "gap of this mesh: the flow has become unstable, most often in the air at a sharp edge; a smaller "
            "max_courant or near_hull helps",
            largest_speed, steps.back().time, limits.air_speed);
    return wrong_volume(steps, limits);
}

std::optional<std::string> water_trouble(const RunRecord& record, const Limits& limits) {
    const Column* fast = record.series("samples", fast_water);
    if (fast && !fast->values.empty() && fast->values.back() > limits.fast_water)
        return fmt::format(
            "{:.2g} % of the water is faster than the {:.4g} m/s that this scene can explain at t = {:.4g} s: the flow "
            "has become unstable; a smaller max_courant or near_hull helps",
            100 * fast->values.back(), limits.water_speed, record.tables.at("samples").time.back());
    const std::optional<double> made = energy_made(record), height = energy_of_height(record);
    if (made && height && *made > limits.energy_made * *height)
        return fmt::format(
            "the water has {:.3g} {} more energy than it had at the start, {:.3g} % of what its height above the floor "
            "gave it, and nothing in this scene does work on it (t = {:.4g} s): the flow has become unstable; a "
            "smaller "
            "max_courant or near_hull helps",
            *made, record.series("samples", "kinetic_energy")->unit, 100 * *made / *height,
            record.tables.at("samples").time.back());
    return {};
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
        "{}: the disk is full: {:.1f} MB are free, {:.1f} MB are needed; free some space and continue with --resume",
        folder.string(), 1e-6 * static_cast<double>(space.available), 1e-6 * needed);
}

}  // namespace tw

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "base/errors.h"
#include "compare/grid_study/steps.h"
#include "methods/methods.h"
#include "record/record_numbers.h"

namespace tw {
namespace {

/// Numbers that follow from the resolution, the length of the run or the machine.
bool follows_from_others(const std::string& name) {
    static const std::set<std::string> names = {"near_hull",
                                                "spacing",
                                                "duration",
                                                "ramp",
                                                "write_interval",
                                                "raster_every",
                                                "cell_far",
                                                "cell_finest",
                                                "wall_particles",
                                                "air_particles",
                                                "sampling_interval",
                                                "bytes_per_particle",
                                                "hull_mesh_error",
                                                "openfoam_self_test_error",
                                                "depth",
                                                "levels",
                                                "finest_spacing",
                                                "jet_spacing",
                                                "size_scale",
                                                "mean_from"};
    return names.contains(name) || name.starts_with("predicted_") || name.starts_with("domain_") ||
           name.starts_with("cut_") || name.starts_with("level_") || name.starts_with("uncertainty:");
}

struct FamilyDifference {
    std::string name, a, b;
    double ratio = std::nan("");  ///< b over a, of a number
};

std::vector<FamilyDifference> differences_of(const Family& a, const Family& b) {
    std::vector<FamilyDifference> out;
    std::set<std::string> names;
    for (const auto* family : {&a, &b})
        for (const auto& [name, value] : family->settings) names.insert(name);
    const auto setting = [](const Family& f, const std::string& name) {
        const auto at = f.settings.find(name);
        return at == f.settings.end() ? std::string("not recorded") : at->second;
    };
    for (const std::string& name : names)
        if (setting(a, name) != setting(b, name)) out.push_back({name, setting(a, name), setting(b, name)});
    for (const auto& [name, x] : a.numbers) {
        const auto at = b.numbers.find(name);
        if (at == b.numbers.end()) continue;
        const double y = at->second;
        if (std::abs(x - y) > 1e-9 * std::max(std::abs(x), std::abs(y)))
            out.push_back({name, fmt::format("{:.6g}", x), fmt::format("{:.6g}", y), y / x});
    }
    return out;
}

}  // namespace

Family family_of(const RunRecord& record) {
    Family f;
    f.hash = text_of(record, "family_hash");
    f.likeness = text_of(record, "hull_hash");
    for (const char* name : {"speed", "draft", "trim", "h_over_dp", "alpha", "c0", "cfl", "shifting",
                             "max_courant_limit", "interface_compression"})
        if (const auto n = record.numbers.find(name); n != record.numbers.end())
            f.likeness += fmt::format(" {}={:.9g}", name, n->second);
    for (const char* name : {"hull_hash", "motion", "equation_of_state", "time_scheme"})
        if (record.attributes.contains(name)) f.settings[name] = text_of(record, name);
    if (const std::string surface = text_of(record, "interface"); !surface.empty() && surface != "mules")
        f.settings["interface"] = surface;
    for (const EffectChoice& e : record.effects) f.settings["effect " + e.name] = e.on ? "on" : "off";
    for (const auto& [name, value] : record.numbers)
        if (!follows_from_others(name) && std::isfinite(value)) f.numbers[name] = value;
    return f;
}

std::string family_differences(const Family& a, const Family& b) {
    std::string out;
    for (const FamilyDifference& d : differences_of(a, b))
        out += fmt::format("{}{} is {} and {}", out.empty() ? "" : ", ", d.name, d.a, d.b);
    return out.empty() ? "they differ in numerics that records do not list (such as touch_support)" : out;
}

bool same_settings(const Family& a, const Family& b) { return differences_of(a, b).empty(); }

std::optional<Varied> variation_between(const Family& base, const Family& varied) {
    const std::vector<FamilyDifference> all = differences_of(base, varied);
    if (all.size() != 1) return {};
    if (all[0].name == "interface" && all[0].b == "isoadvector") return Varied{"geometric surface"};
    if (!(all[0].ratio > 0)) return {};
    const double r = all[0].ratio;
    // The error of weak compressibility falls with Ma^2, so with c0^-2; errors of time stepping are of first order.
    if (all[0].name == "c0" && r > 1) return Varied{fmt::format("sound speed x {:g}", r), 1 / (1 - 1 / (r * r))};
    const std::string share = std::abs(r - 0.5) < 1e-6 ? "half" : fmt::format("{:g} times", r);
    if (all[0].name == "cfl" && r < 1) return Varied{share + " the time step", 1 / (1 - r), 1 / r};
    if (all[0].name == "max_courant_limit" && r < 1) return Varied{share + " the Courant number", 1 / (1 - r), 1 / r};
    return {};
}

std::vector<GridStudySide> sides_of(std::vector<GridStudyRun> runs) {
    std::ranges::sort(runs, [](const GridStudyRun& a, const GridStudyRun& b) {
        return std::tuple(method_rank(a.method), a.method, a.spacing) <
               std::tuple(method_rank(b.method), b.method, b.spacing);
    });
    std::vector<GridStudySide> sides;
    for (GridStudyRun& run : runs) {
        if (sides.empty() || sides.back().method != run.method) sides.push_back({run.method, {}, {}, true});
        GridStudySide& side = sides.back();
        if (!side.runs.empty() && run.spacing <= side.runs.back().spacing * (1 + 1e-6))
            throw InputError(fmt::format("two {} runs with the spacing {:g} m; expected one run of every size",
                                         method_label(side.method), run.spacing));
        if (!side.runs.empty()) {
            const Family &first = side.runs.front().family, &here = run.family;
            const bool hashes = !first.hash.empty() && !here.hash.empty();
            if (hashes && first.hash != here.hash)
                throw InputError(fmt::format(
                    "{0} at {1:g} m and {0} at {2:g} m are not of one family: {3}; expected runs of one scene with one "
                    "set of numerics, which differ in their sizes alone",
                    method_label(side.method), side.runs.front().spacing, run.spacing,
                    family_differences(first, here)));
            side.similar = side.similar && (hashes || first.likeness == here.likeness);
        }
        side.runs.push_back(std::move(run));
    }
    return sides;
}

void add_variation(std::vector<GridStudySide>& sides, GridStudyVariation v) {
    for (GridStudySide& side : sides)
        if (const auto base =
                std::ranges::find_if(side.runs, [&](const GridStudyRun& r) { return same_rung(r, v.run); });
            base != side.runs.end()) {
            weigh(v, *base);
            side.variations.push_back(std::move(v));
            return;
        }
    throw InputError(fmt::format("{} with {}: the study has no {} run of {:g} m that it varies", v.run.method, v.name,
                                 v.run.method, v.run.spacing));
}

}  // namespace tw

#include "compare/report/next_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "record/record_numbers.h"
#include "compare/report/escape.h"
#include "compare/report/numbers.h"
#include "compare/verdict/quantity_kinds.h"
#include "methods/methods.h"

namespace tw {

namespace {

bool any_verdict(const Comparison& c, Verdict verdict) {
    return std::ranges::any_of(main_quantities(c.quantities), [&](const Quantity* q) {
        return std::ranges::any_of(q->differences(), [&](const Difference& d) { return d.verdict == verdict; });
    });
}

/// The longest that a value of a first page is short of [s].
double seconds_missing(const Comparison& c) {
    double most = 0;
    for (const Quantity* q : main_quantities(c.quantities))
        for (const MeanValue& m : q->values)
            if (!m.known) most = std::max(most, m.seconds_needed);
    return most;
}

}  // namespace

std::vector<NextStep> next_steps(const Comparison& c) {
    const RunRecord& first = c.sources.front();
    const std::string file = text_of(first, "scene_file", "scene.toml"), scene = shell_file(file);
    const auto new_folder = [&](const char* what) {
        return " --out " + shell_word("runs/" + std::filesystem::path(file).stem().string() + "_" + what);
    };
    std::vector<NextStep> steps;
    const auto stopped = std::ranges::count_if(c.sources, [](const RunRecord& r) { return r.state == "stopped"; });
    if (stopped > 0)
        steps.push_back({"Finish what was stopped.", "twinwake run " + scene + " --resume"});
    else if (const double missing = seconds_missing(c), duration = number_of(first, "duration", 0);
             missing > 0 && duration > 0)
        steps.push_back({fmt::format("Simulate longer: the means need {} more.", about_text(missing)),
                         fmt::format("twinwake run {} --duration \"{:.3g} s\"{}", scene, 1.05 * (duration + missing),
                                     new_folder("longer"))});
    if (c.sources.size() == 1 && find_method(text_of(first, "method")))
        steps.push_back({"Solve it with the other method as well.", "twinwake run " + scene + " --method both"});
    if (c.sources.size() > 1 && c.discretisation_from.empty())
        steps.push_back({"Run the coarser twins too: only several sizes give the discretisation error and a verdict.",
                         "twinwake run " + scene});
    const bool diverges = any_verdict(c, Verdict::not_converged);
    if (const double size = number_of(first, "near_hull", 0);
        size > 0 && !c.discretisation_from.empty() && (diverges || any_verdict(c, Verdict::undecided)))
        steps.push_back({diverges ? "Refine: a further size shows whether the values converge."
                                  : "Refine: smaller sizes narrow the intervals.",
                         fmt::format("twinwake run {} --near-hull \"{:.3g} mm\"{}", scene, 1e3 * size / std::sqrt(2.0),
                                     new_folder("finer"))});
    if (const double speed = number_of(first, "speed", 0); steps.empty() && is_stream(first) && speed > 0)
        steps.push_back({"See whether it holds at other speeds.",
                         fmt::format("twinwake sweep {} --speeds \"{:.3g} m/s\" \"{:.3g} m/s\" \"{:.3g} m/s\"", scene,
                                     0.8 * speed, speed, 1.25 * speed)});
    if (steps.size() > 3) steps.resize(3);
    return steps;
}

}  // namespace tw

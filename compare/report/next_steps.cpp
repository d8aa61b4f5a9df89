#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <sstream>
#include <string_view>

#include "base/numbers.h"
#include "compare/report/escape.h"
#include "compare/report/first_screen.h"
#include "compare/report/numbers.h"
#include "compare/report/sentences.h"
#include "compare/verdict/quantity_kinds.h"
#include "methods/methods.h"
#include "record/force_names.h"
#include "record/record_numbers.h"

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

/// What the study's own command says of the scene, such as another speed or another size: " --speed '6 m/s'".
/// `without`: options that the next command sets itself.
using Options = std::initializer_list<std::string_view>;
std::string carried_options(const RunRecord& run, Options without = {}) {
    static constexpr std::string_view carried[] = {"--hull",  "--speed",    "--trim",   "--near-hull", "--spacing",
                                                   "--scale", "--duration", "--method", "--effect"};
    std::istringstream lines(text_of(run, "command"));
    std::vector<std::string> words;
    for (std::string word; std::getline(lines, word);) words.push_back(word);
    std::string options;
    const auto is_carried = [&](std::string_view option) {
        return std::ranges::find(without, option) == without.end() &&
               std::ranges::find(carried, option) != std::end(carried);
    };
    for (std::size_t i = 0; i < words.size(); ++i)
        if (const auto equals = words[i].find('=');
            equals != std::string::npos && is_carried(words[i].substr(0, equals)))
            options += " " + shell_word(words[i]);
        else if (is_carried(words[i]) && i + 1 < words.size())
            options += " " + words[i] + " " + shell_word(words[i + 1]), ++i;
    return options;
}

/// A word of the study's own command.
bool was_asked(const RunRecord& run, const std::string& option) {
    return ("\n" + text_of(run, "command")).find("\n" + option) != std::string::npos;
}

/// Options that make a run of the scene file `finer` times as fine as the study's own, which --scale or --budget may have
/// made at other sizes than the file's; 1: at the study's own. Everything else of its command stays, but for `without`.
std::string at_size(const RunRecord& run, double finer, std::string_view without = {}) {
    const double scale = number_of(run, "size_scale", 1) / finer;
    const bool file_s = std::abs(scale - 1) < 1e-9;
    return (file_s ? "" : fmt::format(" --scale {:.4g}", scale)) + carried_options(run, {"--scale", without});
}

/// Of all methods and their coarser members at a size `finer` times as fine: h^-4 in space and time, h^-3 in two
/// dimensions [s]; 0: the records do not say how long they took.
double seconds_at(const Comparison& c, double finer) {
    double sum = 0;
    for (const RunRecord& r : c.sources) {
        const double order = number_of(r, "dimensions", 3) == 2 ? 3 : 4;
        double own = 0;
        for (const Phase& phase : r.phases) own += phase.wall;
        for (const double coarser : {1.0, std::sqrt(2.0), 2.0}) sum += own * std::pow(finer / coarser, order);
    }
    return sum;
}

/// Of the study that was made [s].
double study_seconds(const Comparison& c) { return c.study_seconds > 0 ? c.study_seconds : seconds_at(c, 1); }

/// ", about 25 min of computing here".
std::string time_of(double seconds) {
    return seconds > 0 ? fmt::format(", {} of computing here", about_text(seconds)) : std::string();
}

std::string millimetres(double metres) { return number_text(1e3 * metres) + " mm"; }

/// A main quantity that is not decided yet, and the time of runs that would bring it to the target [s].
struct Open {
    std::string label;
    double seconds = 0;
};
std::vector<Open> open_quantities(const Comparison& c) {
    std::vector<Open> open;
    for (const Quantity* q : main_quantities(c.quantities)) {
        double most = 0;
        for (const Difference& d : q->differences())
            if (d.verdict == Verdict::undecided && d.seconds_to_target > 0) most = std::max(most, d.seconds_to_target);
        if (most > 0 && std::isfinite(most)) open.push_back({lower_case_first(q->label), most});
    }
    return open;
}

/// "lift and trim moment" of those that take more than `above` and at most `most` [s]; their longest time in `seconds`.
std::string open_between(const std::vector<Open>& open, double above, double most, double& seconds) {
    std::vector<std::string> labels;
    seconds = 0;
    for (const Open& o : open)
        if (o.seconds > above && o.seconds <= most) labels.push_back(o.label), seconds = std::max(seconds, o.seconds);
    return labels.empty() ? std::string() : fmt::format("{}", fmt::join(labels, " and "));
}

/// "13h", as --budget reads it; rounded up.
std::string budget_text(double seconds) {
    return seconds < 7200 ? fmt::format("{:.0f}min", std::ceil(seconds / 60))
                          : fmt::format("{:.0f}h", std::ceil(seconds / 3600));
}

/// The next finer size, the time that decides what is open, and what takes too long to be offered.
void add_finer(std::vector<NextStep>& steps, const Comparison& c, const std::string& scene, const std::string& finer_to,
               const std::string& decided_to, bool diverges) {
    const RunRecord& first = c.sources.front();
    const double finer = std::sqrt(2.0), seconds = seconds_at(c, finer), size = number_of(first, "near_hull", 0);
    const double longest = longest_offer(study_seconds(c));
    const std::vector<Open> open = open_quantities(c);
    const std::string target = fmt::format("±{:g} %", 100 * c.agree_within);
    double needed = 0;
    const std::string soon = open_between(open, 0, std::min(seconds, longest), needed);
    steps.push_back({fmt::format("Refine from {} to {} at the hull{}: {}.", millimetres(size),
                                 millimetres(size / finer), time_of(seconds),
                                 diverges       ? "a further size shows whether the values converge"
                                 : soon.empty() ? "smaller sizes narrow the intervals"
                                                : "that would bring " + soon + " to " + target),
                     "twinwake run " + scene + at_size(first, finer) + finer_to});
    if (const std::string later = open_between(open, seconds, longest, needed); !later.empty())
        steps.push_back({fmt::format("Or let it take the sizes that {} of computing allow: that would bring {} to {}.",
                                     time_text(needed), later, target),
                         fmt::format("twinwake run {}{} --budget {}{}", scene,
                                     carried_options(first, {"--scale", "--near-hull", "--spacing"}),
                                     budget_text(needed), decided_to)});
    if (const std::string never = open_between(open, std::max(seconds, longest), HUGE_VAL, needed); !never.empty())
        steps.push_back({fmt::format("To bring {} to {} would take {} of computing, by the slopes of this study.",
                                     never, target, time_text(needed)),
                         ""});
}

}  // namespace

std::vector<NextStep> next_steps(const Comparison& c) {
    const RunRecord& first = c.sources.front();
    const std::string file = text_of(first, "scene_file", "scene.toml"), scene = shell_file(file);
    const auto new_folder = [&](const char* what) {
        return " --out " + shell_word("runs/" + std::filesystem::path(file).stem().string() + "_" + what);
    };
    const double size = number_of(first, "near_hull", 0);
    const bool other_size =
        was_asked(first, "--scale") || was_asked(first, "--budget") || was_asked(first, "--near-hull");
    const std::string at_its_size = size > 0 && other_size ? ", at this study's " + millimetres(size) : "";
    std::vector<NextStep> steps;
    const auto stopped = std::ranges::count_if(c.sources, [](const RunRecord& r) { return r.state == "stopped"; });
    if (stopped > 0)
        steps.push_back({"Finish what was stopped.", "twinwake run " + scene + " --resume"});
    else if (const double missing = seconds_missing(c), duration = number_of(first, "duration", 0);
             missing > 0 && duration > 0)
        steps.push_back(
            {fmt::format("Simulate longer{}: the means need {} more{}.", size > 0 ? " at " + millimetres(size) : "",
                         about_text(missing), time_of(study_seconds(c) * 1.05 * (duration + missing) / duration)),
             fmt::format("twinwake run {}{} --duration \"{:.3g} s\"{}", scene, at_size(first, 1, "--duration"),
                         1.05 * (duration + missing), new_folder("longer"))});
    if (c.sources.size() == 1 && find_method(text_of(first, "method")))
        steps.push_back({"Solve it with the other method as well" + at_its_size + ".",
                         "twinwake run " + scene + at_size(first, 1, "--method") + " --method both"});
    if (c.sources.size() > 1 && c.discretisation_from.empty())
        steps.push_back({"Run the two coarser sizes as well" + at_its_size +
                             ": only several sizes give the discretisation error and a verdict.",
                         "twinwake run " + scene + at_size(first, 1)});
    const bool diverges = any_verdict(c, Verdict::not_converged);
    const bool open = diverges || any_verdict(c, Verdict::undecided) || any_verdict(c, Verdict::no_answer);
    if (size > 0 && !c.discretisation_from.empty() && open)
        add_finer(steps, c, scene, new_folder("finer"), new_folder("decided"), diverges);
    if (const double speed = number_of(first, "speed", 0); steps.empty() && is_stream(first) && speed > 0)
        steps.push_back({"See whether it holds at other speeds.",
                         fmt::format("twinwake sweep {} --speeds \"{:.3g} m/s\" \"{:.3g} m/s\" \"{:.3g} m/s\"", scene,
                                     0.8 * speed, speed, 1.25 * speed)});
    if (steps.size() > 3) steps.resize(3);
    return steps;
}

}  // namespace tw

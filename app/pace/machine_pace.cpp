#include "app/pace/machine_pace.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/cache_folder.h"
#include "base/errors.h"
#include "base/own_json.h"
#include "record/this_machine.h"

namespace tw::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t remembered = 9;
constexpr double shortest = 10;      ///< of a run that may teach anything [s]
constexpr double shortest_fast = 1;  ///< of one that may teach that the machine is faster [s]
constexpr double of_busy_hour = 2;   ///< times the pace of a later run
/// No processor makes the table's second in less: then the table was wrong about the run (a mesh that came out coarser, a
/// run that ended early). A GPU is faster.
constexpr double fastest_processor = 0.35;

fs::path pace_file() {
    const fs::path folder = cache_folder();
    return folder.empty() ? folder : folder / "pace.json";
}

Json read_paces() {
    Json paces = Json::object();
    try {
        if (fs::is_regular_file(pace_file()))
            read_own_json(pace_file(), [&](const nlohmann::json& json) {
                if (json.is_object()) paces = json;
            });
    } catch (const InputError&) {}
    return paces;
}

/// The key of what was measured for a method without a run.
std::string calibration(const std::string& method) { return method.empty() ? "bench" : "bench of " + method; }

/// Paces of this machine under a key, one or a list; what is no pace of any machine, a GPU's included, is left out.
std::vector<double> paces_listed(const Json& paces, const std::string& key) {
    std::vector<double> found;
    const auto take = [&](const Json& r) {
        if (const double v = r.get<double>(); v > 1e-5 && v < 100) found.push_back(v);
    };
    try {
        const Json& of = paces.at(cpu_model()).at(key);
        if (!of.is_array())
            take(of);
        else
            for (const Json& r : of) take(r);
    } catch (const Json::exception&) {}
    return found;
}

bool possible(const std::string& method, double pace) {
    const bool on_a_device = method.find(" on ") != std::string::npos;  // pace_on_gpu
    return on_a_device || pace >= fastest_processor;
}

double median(const Json& paces, const std::string& method) {
    std::vector<double> ratios = paces_listed(paces, method);
    std::erase_if(ratios, [&](double r) { return !possible(method, r); });
    for (const std::string& of : {calibration(method), calibration("")})
        if (ratios.empty()) ratios = paces_listed(paces, of);
    if (ratios.empty()) return 1;
    std::ranges::sort(ratios);
    return 0.5 * (ratios[(ratios.size() - 1) / 2] + ratios[ratios.size() / 2]);
}

/// What cannot be written is silently not learned.
template <class Change>
void change(Change apply) {
    const fs::path file = pace_file();
    if (file.empty()) return;
    try {
        Json paces = read_paces();
        Json& of_machine = paces[cpu_model()];
        if (!of_machine.is_object()) of_machine = Json::object();
        apply(of_machine);
        fs::create_directories(file.parent_path());
        write_text_atomically(file, paces.dump(1) + "\n");
    } catch (const std::exception&) {}
}

}  // namespace

double machine_pace(const std::string& method) { return median(read_paces(), method); }

bool knows_pace(const std::string& method) {
    const Json paces = read_paces();
    return !paces_listed(paces, method).empty() || !paces_listed(paces, calibration(method)).empty();
}

void remember_calibration(const std::string& method, double pace) {
    change([&](Json& of_machine) { of_machine[calibration(method)] = pace; });
}

void learn_pace(const std::string& method, double expected, double taken, bool undisturbed) {
    if (!(taken > shortest_fast) || !(expected > 0)) return;
    const double pace = taken / expected;
    // Other programs and a run's first seconds make it slower, and nothing makes it faster than the machine is.
    const Json paces = read_paces();
    if (!possible(method, pace)) return;
    const bool known = knows_pace(method) || !paces_listed(paces, calibration("")).empty();
    const bool faster = known && pace < median(paces, method);
    if (!faster && (!undisturbed || !(taken > shortest))) return;
    change([&](Json& of_machine) {
        Json kept = Json::array();
        if (of_machine.contains(method) && of_machine[method].is_array())
            for (const Json& r : of_machine[method])
                if (r.is_number() && r.get<double>() <= of_busy_hour * pace) kept.push_back(r);
        kept.push_back(pace);
        while (kept.size() > remembered) kept.erase(kept.begin());
        of_machine[method] = kept;
    });
}

}  // namespace tw::app

#include "app/machine_pace.h"

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

constexpr std::size_t remembered = 5;
constexpr double shortest = 10;  ///< [s]

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
std::vector<double> numbers(const Json& paces, const std::string& key) {
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

double median(const Json& paces, const std::string& method) {
    std::vector<double> ratios = numbers(paces, method);
    for (const std::string& of : {calibration(method), calibration("")})
        if (ratios.empty()) ratios = numbers(paces, of);
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
    return !numbers(paces, method).empty() || !numbers(paces, calibration(method)).empty();
}

void remember_calibration(const std::string& method, double pace) {
    change([&](Json& of_machine) { of_machine[calibration(method)] = pace; });
}

void learn_pace(const std::string& method, double expected, double taken) {
    if (!(taken > shortest) || !(expected > 0)) return;
    change([&](Json& of_machine) {
        Json& ratios = of_machine[method];
        if (!ratios.is_array()) ratios = Json::array();
        ratios.push_back(taken / expected);
        while (ratios.size() > remembered) ratios.erase(ratios.begin());
    });
}

}  // namespace tw::app

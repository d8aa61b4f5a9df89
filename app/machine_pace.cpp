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

double median(const Json& paces, const std::string& method) {
    std::vector<double> ratios;
    try {
        for (const Json& r : paces.at(cpu_model()).at(method))
            if (const double v = r.get<double>(); v > 0.01 && v < 100) ratios.push_back(v);
    } catch (const Json::exception&) {}
    if (ratios.empty()) {  // what doctor measured, else the table's own machine
        try {
            const double bench = paces.at(cpu_model()).at("bench").get<double>();
            return bench > 0.01 && bench < 100 ? bench : 1;
        } catch (const Json::exception&) { return 1; }
    }
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

void remember_calibration(double pace) {
    change([&](Json& of_machine) { of_machine["bench"] = pace; });
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

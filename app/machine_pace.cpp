#include "app/machine_pace.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "record/this_machine.h"

namespace tw::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::size_t remembered = 5;
constexpr double shortest = 10;  ///< [s]

fs::path pace_file() {
    if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache && *cache)
        return fs::path(cache) / "twinwake/pace.json";
    if (const char* home = std::getenv("HOME"); home && *home) return fs::path(home) / ".cache/twinwake/pace.json";
    return {};
}

Json read_paces() {
    try {
        if (fs::exists(pace_file()))
            if (Json paces = Json::parse(read_text(pace_file())); paces.is_object()) return paces;
    } catch (const std::exception&) {}
    return Json::object();
}

double median(const Json& paces, const std::string& method) {
    std::vector<double> ratios;
    try {
        for (const Json& r : paces.at(cpu_model()).at(method))
            if (const double v = r.get<double>(); v > 0.01 && v < 100) ratios.push_back(v);
    } catch (const Json::exception&) {}
    if (ratios.empty()) return 1;
    std::ranges::sort(ratios);
    return 0.5 * (ratios[(ratios.size() - 1) / 2] + ratios[ratios.size() / 2]);
}

}  // namespace

MachinePace machine_pace() {
    const Json paces = read_paces();
    return {median(paces, "sph"), median(paces, "fvm")};
}

void learn_pace(const std::string& method, double expected, double taken) {
    const fs::path file = pace_file();
    if (file.empty() || !(taken > shortest) || !(expected > 0)) return;
    try {
        Json paces = read_paces();
        Json& ratios = paces[cpu_model()][method];
        if (!ratios.is_array()) ratios = Json::array();
        ratios.push_back(taken / expected);
        while (ratios.size() > remembered) ratios.erase(ratios.begin());
        fs::create_directories(file.parent_path());
        write_text_atomically(file, paces.dump(1) + "\n");
    } catch (const std::exception&) {}
}

}  // namespace tw::app

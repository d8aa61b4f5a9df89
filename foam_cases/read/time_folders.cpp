#include "foam_cases/read/time_folders.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>

#include "foam_cases/read/field_file.h"
#include "foam_cases/read/number_rows.h"

namespace tw {
namespace fs = std::filesystem;

namespace {
bool ends_in_closing_line(const fs::path& file) {
    static constexpr std::string_view closing =
        "// ************************************************************************* //";
    std::ifstream in(file, std::ios::binary);
    if (!in) return false;
    in.seekg(0, std::ios::end);
    const auto size = static_cast<long long>(in.tellg());
    in.seekg(std::max(0LL, size - 200));
    std::string end{std::istreambuf_iterator<char>(in), {}};
    while (!end.empty() && (end.back() == '\n' || end.back() == ' ' || end.back() == '\r')) end.pop_back();
    return end.size() >= closing.size() && end.compare(end.size() - closing.size(), closing.size(), closing) == 0;
}
}  // namespace

TimeFolders::TimeFolders(fs::path case_folder)
    : case_(std::move(case_folder)), fields_{"U", "p_rgh", "alpha.water", "phi", "uniform/time"} {
    std::map<long, fs::path> processors;
    std::error_code none;
    for (const auto& e : fs::directory_iterator(case_, none)) {
        const std::string name = e.path().filename().string();
        if (name.rfind("processor", 0) == 0 && e.is_directory())
            if (const auto n = time_of(std::string_view(name).substr(9))) processors[std::lround(*n)] = e.path();
    }
    for (const auto& [n, path] : processors) roots_.push_back(path);
    if (roots_.empty()) roots_ = {case_};
    if (fs::exists(case_ / "0.orig" / "pointDisplacement"))  // cells that move are written anew each time
        for (const std::string& name :
             {std::string("C"), cell_volumes_in(roots_[0] / "0"), std::string("polyMesh/points")})
            fields_.push_back(name);
    for (const char* name : {"k", "omega", "nut"})
        if (fs::exists(case_ / "0.orig" / name)) fields_.push_back(name);
}

std::vector<TimeFolders::Moment> TimeFolders::moments() const {
    std::map<double, std::string> found;
    std::error_code none;
    for (const fs::path& root : roots_)
        for (const auto& e : fs::directory_iterator(root, none))
            if (const auto t = time_of(e.path().filename().string()); t && *t > 0 && e.is_directory())
                found[*t] = e.path().filename().string();
    std::vector<Moment> out;
    for (const auto& [time, name] : found) out.push_back({time, name});
    return out;
}

bool TimeFolders::whole(const Moment& moment) const {
    return std::all_of(roots_.begin(), roots_.end(), [&](const fs::path& root) {
        const fs::path folder = root / moment.name;
        return std::all_of(fields_.begin(), fields_.end(),
                           [&](const std::string& f) { return ends_in_closing_line(folder / f); }) &&
               std::ranges::all_of(fs::recursive_directory_iterator(folder / "uniform"), [](const auto& e) {
                   return !e.is_regular_file() || ends_in_closing_line(e.path());
               });
    });
}

void TimeFolders::remove(const Moment& moment) const {
    std::error_code none;
    for (const fs::path& root : roots_) fs::remove_all(root / moment.name, none);
}

std::vector<std::string> TimeFolders::prune(double interval) const {
    std::vector<std::string> dropped;
    for (const Moment& m : moments()) {
        const double n = interval > 0 ? m.time / interval : 0;
        if (whole(m) && std::abs(n - std::round(n)) <= 1e-4) continue;
        remove(m);
        dropped.push_back(m.name);
    }
    return dropped;
}

void TimeFolders::forget_output_after(double restart) const {
    std::vector<fs::path> stale;
    std::error_code none;
    for (const auto& object : fs::directory_iterator(case_ / "postProcessing", none))
        for (const auto& e : fs::directory_iterator(object.path(), none))
            if (const auto t = time_of(e.path().filename().string()); t && *t > restart * (1 + time_name_precision))
                stale.push_back(e.path());
    for (const fs::path& folder : stale) fs::remove_all(folder, none);
}

}  // namespace tw

#include "foam_cases/doctor.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <sstream>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "foam_cases/flavour.h"
#include "foam_cases/own_openfoam.h"
#include "foam_cases/read/number_rows.h"
#include "foam_cases/run/wrapper.h"
#include "scene/scene.h"

namespace tw {
namespace fs = std::filesystem;

namespace {

const fs::path debian_programs = "/usr/bin";  // its package keeps the rest in /usr/share/openfoam

fs::path environment_path(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? fs::path() : fs::path(value);
}

bool is_program(const fs::path& p) {
    std::error_code none;
    return fs::is_regular_file(p, none) && ::access(p.c_str(), X_OK) == 0;
}

/// "WM_PROJECT_VERSION=v1912" of etc/bashrc; META-INFO/api-info of openfoam.com says "api=2312".
void read_version(OpenFoam& found) {
    const auto behind = [](const std::string& text, const std::string& label) {
        for (std::size_t at = text.find(label); at != std::string::npos; at = text.find(label, at + 1)) {
            if (at > 0 && text.compare(at - std::min<std::size_t>(at, 1), 1, "[") == 0)
                continue;  // a comment that explains it
            std::string value;
            for (std::size_t i = at + label.size();
                 i < text.size() && (std::isalnum(static_cast<unsigned char>(text[i])) || text[i] == '.'); ++i)
                value += text[i];
            if (!value.empty()) return value;
        }
        return std::string();
    };
    std::error_code none;
    if (fs::exists(found.project_dir / "META-INFO/api-info", none)) {
        const std::string api = behind(read_text(found.project_dir / "META-INFO/api-info"), "api=");
        if (!api.empty()) found.version = "v" + api;
    }
    if (found.version.empty() && fs::exists(found.project_dir / "etc/bashrc", none))
        found.version = behind(read_text(found.project_dir / "etc/bashrc"), "WM_PROJECT_VERSION=");
    found.vendor = vendor_of(found.version);
}

/// Fills in programs, version and what is missing; false when no installation is there.
bool look_into(const fs::path& project_dir, OpenFoam& found) {
    std::error_code none;
    if (project_dir.empty() || !fs::exists(project_dir / "etc/controlDict", none)) return false;
    found.project_dir = project_dir;
    found.loaded = fs::equivalent(project_dir, environment_path("WM_PROJECT_DIR"), none);
    for (const auto& options : fs::directory_iterator(project_dir / "platforms", none))
        if (is_program(options.path() / "bin/blockMesh")) found.bin = options.path() / "bin";
    const fs::path wanted = project_dir / "platforms" / environment_path("WM_OPTIONS") / "bin";
    if (is_program(wanted / "blockMesh")) found.bin = wanted;
    if (found.bin.empty() && is_program(debian_programs / "blockMesh") &&
        project_dir.string().starts_with("/usr/share"))
        found.bin = debian_programs;
    read_version(found);
    const std::string solver = Flavour::from_version(found.vendor, found.version).solver_program();
    found.solver = (found.bin.empty() ? project_dir / "platforms" : found.bin) / solver;
    const auto lacks = [&](const std::string& program, const std::string& where) {
        found.verdict = fmt::format("{} {}, unusable: it has no {} in {}; it is not installed or built completely",
                                    found.vendor, found.version, program, where);
    };
    if (found.bin.empty()) {
        lacks("blockMesh", (project_dir / "platforms/*/bin").string());
    } else if (!is_program(found.solver)) {
        lacks(solver, found.bin.string());
    }
    return true;
}

std::vector<fs::path> project_folders(const std::string& preferred) {
    std::vector<fs::path> out;
    if (!preferred.empty()) out.emplace_back(preferred);
    out.push_back(environment_path("WM_PROJECT_DIR"));
    if (const char* places = std::getenv("TWINWAKE_OPENFOAM_PLACES"); places != nullptr) {
        std::stringstream list(places);
        for (std::string place; std::getline(list, place, ':');) out.emplace_back(place);
        return out;
    }
    out.emplace_back("/usr/share/openfoam");
    const auto children = [&](const fs::path& parent, const std::string& prefix) {
        std::vector<fs::path> found;
        std::error_code none;
        for (const auto& e : fs::directory_iterator(parent, none))
            if (e.path().filename().string().rfind(prefix, 0) == 0) found.push_back(e.path());
        std::sort(found.rbegin(), found.rend());  // the newest first
        out.insert(out.end(), found.begin(), found.end());
    };
    children("/usr/lib/openfoam", "openfoam");
    children("/opt", "openfoam");
    children("/opt", "OpenFOAM");
    children(environment_path("HOME") / "OpenFOAM", "OpenFOAM-");
    return out;
}

constexpr const char *walls_file = "libventilatedWall.so", *zones_file = "libforcingZones.so",
                     *hold_file = "libheldBody.so";

/// Built by setup-openfoam for this release (tools/build_openfoam_walls.sh); empty: none.
fs::path library_for(const OpenFoam& found, const char* file) {
    for (const fs::path& folder : own_openfoam_folders()) {
        fs::path library = folder / "walls" / (found.vendor + "-" + found.version) / file;
        if (std::error_code none; fs::exists(library, none)) return library;
    }
    return {};
}

void take_libraries(OpenFoam& found) {
    found.wall_library = library_for(found, walls_file);
    found.zone_library = library_for(found, zones_file);
    found.hold_library = library_for(found, hold_file);
}

/// Built by setup-openfoam with the solver (tools/build_openfoam_solvers.sh); empty: none.
fs::path library_beside(const fs::path& folder, const char* file) {
    fs::path library = folder / "lib" / file;
    std::error_code none;
    return fs::exists(library, none) ? library : fs::path();
}

bool belongs_to(const OpenFoam& found, const std::string& preferred) {
    if (preferred.empty()) return true;
    std::error_code none;
    return fs::equivalent(found.project_dir, preferred, none) ||
           fs::equivalent(found.solver.parent_path(), preferred, none) || fs::equivalent(found.solver, preferred, none);
}

}  // namespace

std::vector<OpenFoam> find_openfoam(const std::string& preferred) {
    if (const std::vector<std::string> prefix = openfoam_prefix(); !prefix.empty()) {
        OpenFoam found = openfoam_behind(prefix);
        take_libraries(found);
        if (found.verdict.empty()) self_test(found);
        return {found};
    }
    std::vector<OpenFoam> installed, all;
    for (const fs::path& folder : project_folders(preferred)) {
        OpenFoam found;
        std::error_code none;
        const bool known = std::any_of(installed.begin(), installed.end(),
                                       [&](const OpenFoam& f) { return fs::equivalent(f.project_dir, folder, none); });
        if (!known && look_into(folder, found)) installed.push_back(found);
    }
    const auto add = [&](OpenFoam found) {  // unless another folder already led to the same program
        std::error_code none;
        if (std::ranges::none_of(all, [&](const OpenFoam& f) { return fs::equivalent(f.solver, found.solver, none); }))
            all.push_back(std::move(found));
    };
    // Mended solvers run on the libraries of the distribution they were built from.
    const auto debian =
        std::find_if(installed.begin(), installed.end(), [](const OpenFoam& f) { return f.bin == debian_programs; });
    if (debian != installed.end())
        for (const fs::path& folder : own_openfoam_folders())
            if (is_program(folder / "bin/interFoam")) {
                OpenFoam mended = *debian;
                mended.solver = folder / "bin/interFoam";
                mended.verdict.clear();
                mended.wall_library = library_beside(folder, walls_file);
                mended.zone_library = library_beside(folder, zones_file);
                mended.hold_library = library_beside(folder, hold_file);
                add(mended);
            }
    for (OpenFoam& f : installed) {
        take_libraries(f);
        add(f);
    }
    std::erase_if(all, [&](const OpenFoam& f) { return !belongs_to(f, preferred); });
    std::stable_partition(all.begin(), all.end(), [](const OpenFoam& f) { return f.loaded; });
    for (OpenFoam& candidate : all)
        if (candidate.verdict.empty()) self_test(candidate);
    return all;
}

OpenFoam sound_openfoam(const std::string& preferred) {
    std::vector<OpenFoam> all = find_openfoam(preferred);
    const bool loaded = !all.empty() && all.front().loaded;
    if (loaded) std::erase_if(all, [](const OpenFoam& f) { return !f.loaded; });
    for (const OpenFoam& f : all)
        if (f.sound) return f;
    std::string text;
    for (const OpenFoam& f : all) text += fmt::format("\n  {}: {}", f.command(), f.verdict);
    if (all.empty()) {
        const std::string where = preferred.empty() ? "on this machine" : "in '" + preferred + "'";
        throw InputError(
            "no OpenFOAM was found " + where +
            " (looked at WM_PROJECT_DIR, /usr/share/openfoam, /usr/lib/openfoam, /opt, ~/OpenFOAM).\n"
            "  Debian, Ubuntu: sudo apt-get install --no-install-recommends openfoam, then " +
            setup_command() +
            "\n"
            "  others: a release of openfoam.com or openfoam.org, its etc/bashrc sourced; or run with --method sph");
    }
    if (loaded && all.front().bin != debian_programs)
        throw InputError("the OpenFOAM whose environment is loaded (WM_PROJECT_DIR) cannot be used:" + text +
                         "\n  start from a shell without that environment, or name another release's folder: "
                         "[fvm] openfoam = \"...\"");
    if (!all.empty() && !all.front().prefix.empty())
        throw InputError("the OpenFOAM behind TWINWAKE_OPENFOAM_PREFIX cannot be used:" + text +
                         "\n  unset it to take one of this machine");
    throw InputError("no sound OpenFOAM solver was found; a faulty one is never used:" + text + "\n  Debian, Ubuntu: " +
                     setup_command() + " builds a sound interFoam in two minutes, from the package's own source");
}

OpenFoam openfoam_for(const Scene& scene) {
    OpenFoam openfoam = sound_openfoam(scene.fvm.openfoam);
    if (!scene.fvm.captures_geometrically()) return openfoam;
    openfoam.solver.replace_filename(geometric_solver);
    const auto refuse = [&](const std::string& why) {
        throw InputError(
            fmt::format("{}: \"isoadvector\" needs {}: {}; expected \"mules\", or for the packages of Debian "
                        "and Ubuntu {} {}",
                        scene.place_of("fvm.interface"), geometric_solver, why, setup_command(), geometric_solver));
    };
    if (openfoam.prefix.empty() && !is_program(openfoam.solver)) refuse(openfoam.solver.string() + " is not there");
    self_test(openfoam);
    if (!openfoam.sound) refuse(openfoam.verdict);
    return openfoam;
}

}  // namespace tw

#include "foam_cases/run/environment.h"

#include <unistd.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace tw {
namespace fs = std::filesystem;

namespace {

using Variables = std::map<std::string, std::string>;

/// Takes out what the release whose environment is loaded has put there: its libraries do not go with other programs.
void unload(Variables& variables) {
    std::vector<fs::path> roots;
    for (const char* root : {"WM_PROJECT_DIR", "WM_THIRD_PARTY_DIR", "WM_PROJECT_USER_DIR"})
        if (!variables[root].empty())
            roots.push_back((fs::path(variables[root]) / "").lexically_normal().parent_path());
    const auto lies_in = [](const fs::path& path, const fs::path& root) {
        return std::mismatch(root.begin(), root.end(), path.begin(), path.end()).first == root.end();
    };
    for (const char* name : {"PATH", "LD_LIBRARY_PATH"}) {
        std::string kept;
        std::istringstream folders(variables[name]);
        for (std::string folder; std::getline(folders, folder, ':');)
            if (std::none_of(roots.begin(), roots.end(),
                             [&](const fs::path& root) { return lies_in(fs::path(folder).lexically_normal(), root); }))
                kept += (kept.empty() ? "" : ":") + folder;
        variables[name] = kept;
    }
    std::erase_if(variables,
                  [](const auto& v) { return v.first.rfind("WM_", 0) == 0 || v.first.rfind("FOAM_", 0) == 0; });
}

/// Library folders of a stock installation: its own, the one of an MPI (`mpi` if it is there; the dummy if no other
/// is), and the third-party ones.
std::string library_path(const OpenFoam& openfoam, const std::string& mpi) {
    std::string path;
    const auto append = [&](const fs::path& p) {
        std::error_code none;
        if (fs::is_directory(p, none)) path += (path.empty() ? "" : ":") + p.string();
    };
    const fs::path lib = openfoam.bin.parent_path() / "lib";  // platforms/<options>/lib beside .../bin
    if (!fs::exists(lib / "libOpenFOAM.so")) return path;     // Debian's layout: the linker knows where they are
    std::error_code none;
    std::vector<fs::path> inner;
    for (const auto& e : fs::directory_iterator(lib, none))
        if (e.is_directory() && fs::exists(e.path() / "libPstream.so")) inner.push_back(e.path());
    // A real MPI comes before the dummy that can only run serially.
    const auto rank = [&](const fs::path& p) { return p.filename() == mpi ? 0 : p.filename() == "dummy" ? 2 : 1; };
    std::sort(inner.begin(), inner.end(),
              [&](const fs::path& a, const fs::path& b) { return std::pair(rank(a), a) < std::pair(rank(b), b); });
    for (const fs::path& p : inner) append(p);
    append(lib);
    for (const fs::path& third :
         {openfoam.project_dir / "ThirdParty", openfoam.project_dir.parent_path() / ("ThirdParty-" + openfoam.version)})
        for (const auto& options : fs::directory_iterator(third / "platforms", none)) {
            append(options.path() / "lib");
            append(options.path() / "lib64");
        }
    return path;
}

}  // namespace

std::vector<std::string> environment_of(const OpenFoam& openfoam, const fs::path& folder) {
    Variables variables;
    for (char** e = environ; *e != nullptr; ++e) {
        const std::string entry = *e;
        const std::size_t equals = entry.find('=');
        if (equals != std::string::npos && equals > 0) variables[entry.substr(0, equals)] = entry.substr(equals + 1);
    }
    if (!openfoam.loaded) unload(variables);
    const auto in_front = [&](const char* name, const std::string& value) {
        if (value.empty()) return;
        std::string& v = variables[name];
        v = v.empty() ? value : value + ":" + v;
    };
    if (openfoam.prefix.empty()) {  // what stands there brings its own
        in_front("PATH", openfoam.bin.string());
        in_front("LD_LIBRARY_PATH", library_path(openfoam, variables["FOAM_MPI"]));
        variables["WM_PROJECT_DIR"] = openfoam.project_dir.string();
        variables["FOAM_ETC"] = (openfoam.project_dir / "etc").string();
        variables["WM_PROJECT_VERSION"] = openfoam.version;
    }
    variables["FOAM_SIGFPE"] = "true";  // a division by zero ends the run instead of spreading
    variables["LC_ALL"] = "C";
    // Fields are made and thrown away all the time. By default glibc takes large ones from the system and gives them
    // back, and each of their pages is filled with zeros once more: 5 % of a run. The first is its largest threshold.
    variables.try_emplace("MALLOC_MMAP_THRESHOLD_", "33554432");
    variables.try_emplace("MALLOC_TRIM_THRESHOLD_", "1073741824");
    variables.try_emplace("MALLOC_TOP_PAD_", "67108864");
    variables["PWD"] = folder.string();  // OpenFOAM warns of one that is not the folder it runs in
    for (const char* name : {"FOAM_CASE", "FOAM_CASENAME", "WM_PROJECT_SITE"}) variables.erase(name);
    if (::geteuid() == 0) variables["OMPI_ALLOW_RUN_AS_ROOT"] = variables["OMPI_ALLOW_RUN_AS_ROOT_CONFIRM"] = "1";
    std::vector<std::string> out;
    for (const auto& [name, value] : variables) out.push_back(name + "=" + value);
    return out;
}

fs::path find_program(const std::vector<std::string>& environment, const std::string& name) {
    for (const std::string& entry : environment) {
        if (entry.rfind("PATH=", 0) != 0) continue;
        std::string path = entry.substr(5) + ":";
        for (std::size_t at = 0, colon; (colon = path.find(':', at)) != std::string::npos; at = colon + 1) {
            const std::string folder = path.substr(at, colon - at);
            if (folder.empty()) continue;
            const fs::path candidate = fs::path(folder) / name;
            if (::access(candidate.c_str(), X_OK) == 0 && fs::is_regular_file(candidate)) return candidate;
        }
    }
    return {};
}

}  // namespace tw

#include "foam_cases/run/environment.h"

#include <unistd.h>

#include <algorithm>
#include <map>

namespace tw {
namespace fs = std::filesystem;

namespace {

/// Library folders of a stock installation: its own, the one of an MPI (else the dummy), and the third-party ones.
std::string library_path(const OpenFoam& openfoam) {
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
    std::sort(inner.begin(), inner.end(), [](const fs::path& a, const fs::path& b) {
        const bool da = a.filename() == "dummy", db = b.filename() == "dummy";
        return da != db ? db : a < b;
    });
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

std::vector<std::string> environment_of(const OpenFoam& openfoam) {
    std::map<std::string, std::string> variables;
    for (char** e = environ; *e != nullptr; ++e) {
        const std::string entry = *e;
        const std::size_t equals = entry.find('=');
        if (equals != std::string::npos && equals > 0) variables[entry.substr(0, equals)] = entry.substr(equals + 1);
    }
    const auto in_front = [&](const char* name, const std::string& value) {
        if (value.empty()) return;
        std::string& v = variables[name];
        v = v.empty() ? value : value + ":" + v;
    };
    in_front("PATH", openfoam.bin.string());
    in_front("LD_LIBRARY_PATH", library_path(openfoam));
    variables["WM_PROJECT_DIR"] = openfoam.project_dir.string();
    variables["FOAM_ETC"] = (openfoam.project_dir / "etc").string();
    variables["WM_PROJECT_VERSION"] = openfoam.version;
    variables["FOAM_SIGFPE"] = "true";  // a division by zero ends the run instead of spreading
    variables["LC_ALL"] = "C";
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

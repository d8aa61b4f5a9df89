#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "foam_cases/flavour.h"
#include "foam_cases/openfoam.h"
#include "foam_cases/run/child.h"
#include "foam_cases/run/temporary_folder.h"

namespace tw {

/// What a run of child processes reports and asks while it waits, several times a second. Return true to stop the
/// child.
using Watch = std::function<bool(ChildProcess&)>;

/// Runs OpenFOAM programs in one case. OpenFOAM refuses paths with blanks, quotes and the like; such a case is reached
/// through a symbolic link in the system's temporary folder, which lives as long as this object.
class CasePrograms {
public:
    CasePrograms(const OpenFoam& openfoam, std::filesystem::path case_folder);
    CasePrograms(const CasePrograms&) = delete;
    CasePrograms& operator=(const CasePrograms&) = delete;

    /// Starts `program` (a name: of the installation's own folder; or a path), on `ranks` processes through mpirun when >
    /// 1; output is appended to log.<log_name>. Throws RunError when the program or mpirun is not there.
    std::unique_ptr<ChildProcess> start(const std::filesystem::path& program, std::vector<std::string> arguments,
                                        const std::string& log_name, int ranks = 1) const;
    /// Runs to the end. Throws RunError with the program's own message when it fails; returns early (status not 0) when
    /// `watch` stopped it.
    Ended run(const std::filesystem::path& program, const std::vector<std::string>& arguments, const Watch& watch,
              const std::string& log_name = {}) const;

    const OpenFoam& openfoam() const { return openfoam_; }
    const std::filesystem::path& case_folder() const { return case_; }
    std::filesystem::path log(const std::string& name) const { return case_ / ("log." + name); }
    /// Behind a prefix it is not asked for: mpirun of the container then says what is wrong.
    bool has_mpi() const { return !openfoam_.prefix.empty() || !find_mpirun().empty(); }

private:
    std::filesystem::path find_mpirun() const;
    OpenFoam openfoam_;
    std::optional<TemporaryFolder> aside_;        ///< of the link; empty where the programs take the case's own path
    std::filesystem::path case_, folder_, link_;  ///< folder_: where the programs run
    std::vector<std::string> environment_;
};

/// OpenFOAM's error message in a log, or else its last lines; at most about 20 lines.
std::string why_it_failed(const std::filesystem::path& log);

}  // namespace tw

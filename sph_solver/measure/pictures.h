#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "record/run_record.h"
#include "record/snapshot.h"
#include "sph_solver/simulation.h"

namespace tw {

/// What is drawn of one moment of a run: it owns all of it, and knows no simulation.
struct Picture {
    /// Active particles of one material, or a surface.
    struct Cloud {
        std::string name;
        double time;               ///< [s]
        std::vector<Vec3> places;  ///< [m]
        std::vector<Field> fields;
    };
    struct OfSurface {
        std::string name;
        Surface surface;
        std::vector<Field> fields;
    };
    double time = 0;  ///< [s]
    std::vector<Cloud> clouds;
    std::vector<OfSurface> surfaces;
    RunRecord water;  ///< with the last frame of the raster, and what its surface is drawn by
};

/// Of the run as it is now: particles, the water's surface, bodies where they are, and the hull with its pressure. All
/// ranks call it, and the first one has it.
Picture picture_of(const Simulation& simulation, const RunRecord& record);

/// ParaView's files of a run, and their series.
class Pictures {
public:
    explicit Pictures(const std::filesystem::path& folder) : folder_(folder / "snapshots") {}
    const std::filesystem::path& folder() const { return folder_; }
    void write(const Picture& picture);
    /// After a restart: what the series have up to `time`. Files that no series names stay where they are.
    void find_written(double time);

private:
    using Series = std::vector<std::pair<std::string, double>>;

    void note(const std::string& name, const char* ending, const std::string& file, double time);
    void write_water(const RunRecord& record);

    std::filesystem::path folder_;
    std::map<std::string, Series> series_;  ///< by the name of what they show
};

}  // namespace tw

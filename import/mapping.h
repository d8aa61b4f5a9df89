#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/vec3.h"
#include "import/logger_csv.h"

namespace tw {

/// One column of the record and where it comes from: value = scale * unit * cell + offset, in SI.
struct ColumnSource {
    std::string table, name, si_unit;  ///< in the record: "forces", "fz", "N"
    std::string header;                ///< of the file's column, as written there; empty: `number` says it
    int number = 0;                    ///< of the file's column, from 1
    std::string unit;                  ///< of the file; empty: the one its header gives, as in "Lift [kN]"
    double scale = 1;                  ///< [-], not 0
    double offset = 0;                 ///< [SI unit]
    double uncertainty = 0;            ///< half width of the measurement's 95 % interval [SI unit]; 0: not known
    std::string place;                 ///< `mapping.toml:8:6: [forces] fz = ...`, for messages
};

/// Where the water is: a file with a row for each particle or cell at each time.
struct WaterSource {
    std::filesystem::path source;
    ColumnSource time, x, y, z, volume;  ///< [s]; centre [m]; of the water in it [m3]
    std::optional<ColumnSource> cell;    ///< volume of the whole cell [m3]; none: particles, cubes of water
};

/// The contents of a mapping file, checked as far as possible without the files it names.
struct Mapping {
    std::filesystem::path file;
    std::string kind;                        ///< csv, openfoam, dualsphysics
    std::string name;                        ///< of the method, in tables and the report
    std::filesystem::path source;            ///< file, or case folder (openfoam)
    std::filesystem::path scene;             ///< scene file, or the record of a run of it (.h5)
    bool half_model = false;                 ///< the source's loads are those of half a hull
    std::optional<Vec3> moment_point;        ///< the source's moments are about this point [m], in the scene's axes
    std::optional<bool> friction;            ///< whether the drag holds friction
    std::string function_object = "forces";  ///< openfoam: the folder in postProcessing
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< openfoam: case axes to scene axes, a rotation
    std::optional<ColumnSource> time;                    ///< csv: always
    std::vector<ColumnSource> columns;
    std::optional<WaterSource> water;
    std::optional<double> near_hull;  ///< the source's size at the hull [m]
    LoggerForm form;                  ///< csv: how its table is written

    std::map<std::string, std::string> place;  ///< of every key of the top level, for messages
};

/// Reads and checks a mapping file; its sources and `scene` are relative to its folder. Throws InputError
/// `file:line:column: ...`: not TOML, unknown key (with the known ones), missing key, bad name, unit of another kind.
Mapping read_mapping(const std::filesystem::path& file);

}  // namespace tw

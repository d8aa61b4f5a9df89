#pragma once
#include <filesystem>
#include <limits>
#include <vector>

#include "spray/extract/element.h"

namespace tw::spray {

/// Frames of a run that can be read, in the order of time; what is in them is read one at a time.
struct FrameFile {
    double time = 0;             ///< [s]
    std::filesystem::path file;  ///< particles of SPH: particles_*.hdf; interFoam: the time folder of the case
};

/// Which part of a run is looked at, and what of it.
struct FrameRange {
    double from = -std::numeric_limits<double>::infinity(), to = std::numeric_limits<double>::infinity();  ///< [s]
};

/// The snapshots below `run` (RUN/sph, or its folder snapshots) within `range`. Throws InputError: none there.
std::vector<FrameFile> particle_frames(const std::filesystem::path& run, const FrameRange& range);
/// All water of one snapshot: a particle is a cube of its spacing. Throws InputError naming the file: not readable,
/// not a snapshot, damaged, or of two dimensions.
WaterFrame read_particles(const FrameFile& frame);

/// The written times of an interFoam case (RUN/fvm, or the case's folder) within `range`; needs alpha.water and U
/// there, and the cells' centres C and volumes V in 0, as twinwake's own cases have them. Throws InputError.
std::vector<FrameFile> foam_frames(const std::filesystem::path& run, const FrameRange& range);
/// All cells of one time that hold water; `least` is the share of water below which a cell is left out [-].
/// `left_out` gets their water [m3]. Throws InputError naming the case.
WaterFrame read_cells(const FrameFile& frame, double least, double& left_out);

/// With its mirror image in the plane y = 0: a half model's other side.
WaterFrame mirrored(WaterFrame frame);

}  // namespace tw::spray

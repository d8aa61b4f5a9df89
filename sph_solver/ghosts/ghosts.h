#pragma once
#include <vector>

#include "sph_solver/domain/level_setup.h"
#include "sph_solver/domain/surroundings.h"
#include "sph_solver/fields/records.h"
#include "sph_solver/ghosts/mirrors.h"
#include "sph_solver/neighbours/columns.h"

namespace tw {

/// Particles that a level sees and does not own: the mirror images at slip walls, symmetry planes and periodic faces.
/// They are found when the lists are made, and refreshed at stated moments of an evaluation. Their records stand
/// behind those of the particles.
class Ghosts {
public:
    /// `around` must outlive this.
    Ghosts(const Surroundings& around, const LevelSetup& level, const Quanta& quanta);

    /// Which particles have images within `reach` [m] of a plane, in the order of the columns.
    void find(const Surroundings& around, const Particles& particles, const ColumnGrid& grid, const Quanta& quanta,
              double reach);

    enum class What {
        places_and_velocities,  ///< before the first sweep
        all                     ///< before the second: density, pressure and density gradient too
    };
    /// Gives the images what their sources have at time `t`.
    void refresh(Records& records, const Particles& sources, double t, const Quanta& quanta, What what) const;

    const std::vector<MirrorImage>& images() const { return images_; }
    const std::vector<std::int32_t>& start() const { return start_; }  ///< first image of each column
    std::size_t bytes() const { return images_.capacity() * sizeof(MirrorImage); }

private:
    const Surroundings& around_;
    Hydrostatic still_;
    MirrorPlanes planes_;
    std::vector<MirrorImage> images_;
    std::vector<std::int32_t> start_;
};

}  // namespace tw

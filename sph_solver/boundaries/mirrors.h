#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "base/vec3.h"
#include "sph_solver/core/columns.h"
#include "sph_solver/core/pair_data.h"
#include "sph_solver/core/particles.h"

namespace tw {

/// Slip walls and symmetry planes on faces of the domain box, by exact mirror images: [axis][0 low, 1 high].
struct Mirrors {
    std::array<std::array<bool, 2>, 3> on{};
};

/// One image of a particle: reflected at the low (1) or high (2) plane of each axis, two bits an axis.
struct MirrorImage {
    std::int32_t source = 0;
    std::uint8_t planes = 0;
    int plane(int axis) const { return (planes >> (2 * axis)) & 3; }
};

/// All images of particles within `reach` of a plane, corners included.
std::vector<MirrorImage> make_mirror_images(const Mirrors& mirrors, const Box& domain, const Particles& particles, double reach);

/// Planes as twice their place in quanta, so that an image is 2 plane - x exactly.
struct MirrorPlanes {
    std::int64_t twice[3][2];
    MirrorPlanes(const Box& domain, const Quanta& quanta);
    PlaceRecord place(PlaceRecord p, const MirrorImage& image) const;
};
MotionRecord mirrored(MotionRecord m, const MirrorImage& image);
StressRecord mirrored(StressRecord s, const MirrorImage& image);

/// A particle that has crossed a plane has changed places with its own image: puts it back. Returns how many.
std::int64_t return_from_mirrors(const Mirrors& mirrors, const Box& domain, Particles& particles);

}  // namespace tw

#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec3.h"
#include "sph_solver/domain/mirrors.h"
#include "sph_solver/fields/particles.h"
#include "sph_solver/loops/cross.h"
#include "sph_solver/loops/link_map.h"
#include "sph_solver/neighbours/pencils.h"

namespace tw {

/// All maps of a domain, by the numbers that ImagesNear gives.
class LinkMaps {
public:
    LinkMaps(const Mirrors& mirrors, const Box& domain, const FixedPoint& fixed_point);
    const LinkMap& operator[](const Link& link) const { return maps_[link.map]; }
    std::span<const LinkMap> all() const { return maps_; }  ///< by Link::map

private:
    std::array<LinkMap, 512> maps_;
};

Faces faces_of(const Mirrors& mirrors, const Box& domain);

/// All images of particles within `reach` of a plane or periodic face, corners included.
std::vector<Link> find_images(const Mirrors& mirrors, const Box& domain, const Particles& particles, double reach);

}  // namespace tw

#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec3.h"
#include "sph_solver/domain/mirrors.h"
#include "sph_solver/fields/particles.h"
#include "sph_solver/ghosts/link_map.h"
#include "sph_solver/neighbours/columns.h"

namespace tw {

/// All maps of a domain. In link.cpp alone a map's number is taken apart: it has three bits an axis, beyond the low (1) or high
/// (2) face, reflected there, or (with 4) moved by the domain's length.
class LinkMaps {
public:
    LinkMaps(const Mirrors& mirrors, const Box& domain, const Quanta& quanta);
    const LinkMap& operator[](const Link& link) const { return maps_[link.map]; }
    std::span<const LinkMap> all() const { return maps_; }  ///< by Link::map

private:
    std::array<LinkMap, 512> maps_;
};

/// All images of particles within `reach` of a plane or periodic face, corners included.
std::vector<Link> find_images(const Mirrors& mirrors, const Box& domain, const Particles& particles, double reach);

}  // namespace tw

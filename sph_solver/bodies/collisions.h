#pragma once
#include <string>
#include <vector>

#include "meshes/zone.h"
#include "sph_solver/bodies/body.h"
#include "sph_solver/bodies/elastic/tie.h"
#include "sph_solver/particles/level_setup.h"

namespace tw {

/// Whether bodies that move touch a wall of the tank, a fixed solid or each other, or have left the domain. What comes
/// then is not solved: a run ends there. Particles cannot enter a gap below half a spacing between solids, so solids that
/// near touch; a wall of the tank is touched at its face. Where an elastic body stands within a spacing of another solid
/// or a wall at the start, as at its supports, it may touch them; and an elastic
/// body whose contact with the floor is solved (elastic/elastic_setup.h) may touch that.
class Collisions {
public:
    /// Both must outlive this.
    Collisions(const std::vector<Body>& bodies, const Surroundings& around, double dp);
    /// The zone of the finest particles, which need not follow a body everywhere (must outlive this): a body that comes
    /// nearer to its edge below still water, z = 0, than the guards of that edge reach is found as well.
    void stay_within(const Zone& zone) { zone_ = &zone; }
    /// The first in words; empty: none.
    std::string found() const;

private:
    std::string with_domain(const Body& body) const;
    std::string with_edge(std::size_t body) const;
    void note_elastic(std::size_t body);
    std::string of_elastic(std::size_t body) const;

    const std::vector<Body>& bodies_;
    const Surroundings& around_;
    double dp_;
    const Zone* zone_ = nullptr;
    std::vector<std::vector<Vec3>> skin_;  ///< of each rigid body places on its surface at the start; else empty
    std::vector<std::vector<Tie>> ties_;   ///< of each elastic body such places; else empty
};

}  // namespace tw

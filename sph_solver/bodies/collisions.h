#pragma once
#include <string>
#include <vector>

#include "meshes/zone.h"
#include "sph_solver/bodies/body.h"
#include "sph_solver/domain/surroundings.h"

namespace tw {

/// Whether bodies that move touch a wall of the tank, a fixed solid or each other, or have left the domain. What comes
/// then is not solved: a run ends there. Particles cannot enter a gap below half a spacing between solids, so solids as
/// near as that touch; a wall of the tank is touched at its face. Where a body that deforms stands within a spacing of
/// another solid or a wall at the start, as at its supports, it may touch them; and one whose contact with a wall of
/// the tank is solved may touch that.
class Collisions {
public:
    /// Both must outlive this.
    Collisions(const Bodies& bodies, const Surroundings& around, double dp);
    /// The zone of the finest particles, which need not follow a body everywhere (must outlive this): a body that comes
    /// nearer to its edge below still water, z = 0, than the buffer particles of that edge reach is found as well.
    void stay_within(const Zone& zone) { zone_ = &zone; }
    /// The first in words; empty: none. With `gap` [m] what is as near as that counts as touching too.
    std::string found(double gap = 0) const;

private:
    std::string with_domain(const Body& body, double gap) const;
    std::string with_edge(std::size_t body) const;
    std::vector<Vec3> clear_at_start(std::size_t body, const std::vector<Vec3>& places) const;
    std::string of_rigid(std::size_t body, double gap) const;
    std::string of_a_deformable_one(std::size_t body, double gap) const;

    const Bodies& bodies_;
    const Surroundings& around_;
    double dp_;
    const Zone* zone_ = nullptr;
    std::vector<std::unique_ptr<Attached>> on_surface_;  ///< places on the surface of each body that moves; else null
};

}  // namespace tw

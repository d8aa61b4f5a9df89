#pragma once
#include <string>
#include <vector>

#include "sph_solver/bodies/body.h"
#include "sph_solver/particles/level_setup.h"

namespace tw {

/// Whether bodies that move touch a wall of the tank, a fixed solid or each other, or have left the domain. Contact is
/// not solved: a run ends there. Particles cannot enter a gap below half a spacing between solids, so that is contact
/// already; a wall of the tank is touched at its face.
class Contacts {
public:
    /// Both must outlive this.
    Contacts(const std::vector<Body>& bodies, const Surroundings& around, double dp);
    /// The first contact in words; empty: none.
    std::string found() const;

private:
    std::string with_domain(const Body& body) const;

    const std::vector<Body>& bodies_;
    const Surroundings& around_;
    double dp_;
    std::vector<std::vector<Vec3>> skin_;  ///< of each body places on its surface at the start; empty of fixed ones
};

}  // namespace tw

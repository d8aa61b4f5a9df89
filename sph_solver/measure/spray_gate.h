#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "base/vec3.h"
#include "scene/sph_options.h"

namespace tw {

class AllParticles;
class Simulation;

/// Detached water that has left a run, as one lump.
struct SprayLump {
    Vec3 place = Vec3::Zero(), velocity = Vec3::Zero();  ///< of its centre of mass [m], [m/s]
    double mass = 0;                                     ///< [kg]
    double inner_energy = 0;                             ///< kinetic energy about that velocity [J]
    std::int64_t particles = 0;
};

/// A plane beyond which water that does not hang on the rest is taken out of the run: it flies on its own, costs steps
/// and does nothing to the rest. Two particles hang together up to `link` spacings apart (record/components.h); what
/// has a particle of the inlet or outlet in it stays.
class SprayGate {
public:
    /// Nothing where the options have none.
    static std::optional<SprayGate> of(const SphOptions& options);

    /// Takes the lumps whose centre is beyond out of the run, whose particles count as out; with several sizes of
    /// particles also those that stand for them in another size. Between two steps, when nothing looks at the last
    /// evaluation any more: levels that lose any go on as after a restart. Of several ranks all call it; the first one
    /// searches all of the water, and each takes out what it holds.
    std::vector<SprayLump> take(Simulation& simulation) const;

    /// What goes at one moment.
    struct Leaving {
        struct OfSize {
            std::vector<std::int64_t> ids = {};  ///< also of those that stand for the water of another size
            std::int64_t active = 0;             ///< of those that are water themselves
        };
        std::vector<SprayLump> lumps = {};
        std::vector<OfSize> sizes = {};  ///< of the particles, by level
    };

private:
    bool is_beyond(const Vec3& x) const;
    bool any_beyond(const Simulation& simulation) const;  ///< water of this process
    void find(const Simulation& simulation, const AllParticles& particles, Leaving& leaving) const;

    SprayGate(const Vec3& point, const Vec3& normal, double link) : point_(point), normal_(normal), link_(link) {}
    Vec3 point_, normal_;
    double link_;
};

}  // namespace tw

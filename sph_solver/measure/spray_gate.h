#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "scene/sph_options.h"
#include "base/vec3.h"

namespace tw {

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
    /// evaluation any more: levels that lose any go on as after a restart.
    std::vector<SprayLump> take(Simulation& simulation) const;

private:
    SprayGate(const Vec3& point, const Vec3& normal, double link) : point_(point), normal_(normal), link_(link) {}
    Vec3 point_, normal_;
    double link_;
};

}  // namespace tw

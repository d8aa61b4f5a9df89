#include "scene/elastic/elastic_tyre.h"

#include <fmt/format.h>

#include "base/errors.h"
#include "structure/degrees_of_freedom.h"
#include "structure/solid/solid.h"

namespace tw {

structure::Solid solid_of(const ElasticTyre& tyre) {
    structure::SolidMesh mesh = structure::tyre_mesh(tyre.shape);
    for (Vec3& p : mesh.nodes) p += tyre.axle;
    return structure::Solid(std::move(mesh), tyre.rubbers());
}

structure::DegreesOfFreedom dofs_of(const ElasticTyre& tyre, const structure::Solid& solid) {
    double own = 0;
    for (int n = 0; 3 * n < solid.dofs(); ++n) own += solid.mass()[3 * n];
    structure::RigidPart rim;
    rim.centre = tyre.axle;
    rim.mass = tyre.total_mass - own;
    if (!(rim.mass > 0))
        throw InputError(fmt::format(
            "the rubber alone has {:.4g} kg; expected a larger mass, that of tyre, rim and load together", own));
    rim.nodes = solid.mesh().sets.at("rim");
    for (std::size_t a = 0; a < 3; ++a) rim.held[a] = tyre.locked[a];
    structure::DegreesOfFreedom dofs(solid.mesh().nodes, 3);
    dofs.carry(std::move(rim));
    return dofs;
}

}  // namespace tw

#include "scene/solids/added_mass.h"

#include <algorithm>
#include <numbers>

#include "meshes/mass_properties.h"

namespace tw {

double added_mass(const MovingBody& body, const Scene& scene) {
    const Box box = body.surface.bounds();
    const Vec3 size = box.size();
    const bool flat = scene.domain.dimensions == 2;
    const double wide = flat ? size.x() : std::min(size.x(), size.y()), along = flat ? 1 : std::max(size.x(), size.y());
    const double sides = box.max.z() < 0 ? 2 : 1;
    const double plate = sides * std::numbers::pi / 8 * wide * wide * along,
                 own = scene.hull ? 0 : mass_properties(body.surface).volume;
    return scene.water.density * std::max(plate, own);
}

}  // namespace tw

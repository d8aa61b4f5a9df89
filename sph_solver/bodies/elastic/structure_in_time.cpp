#include "sph_solver/bodies/elastic/structure_in_time.h"

#include "sph_solver/bodies/elastic/shell_in_time.h"
#include "sph_solver/bodies/elastic/solid_in_time.h"
#include "structure/shell/skin.h"
#include "structure/solid/wet_surface.h"

namespace tw {

std::unique_ptr<StructureInTime> structure_in_time(const ElasticSetup& setup) {
    if (std::holds_alternative<ElasticSolid>(setup.structure)) return solid_in_time(setup);
    return setup.shell().large_rotations ? turning_shell(setup) : linear_shell(setup);
}

Surface wetted_surface_of(const ElasticSetup& setup) {
    if (const auto* of = std::get_if<ElasticSolid>(&setup.structure))
        return structure::WetSurface(of->solid, of->wet, of->start).closed();
    return structure::Skin(setup.shell().shell, setup.shell().skin).reference();
}

}  // namespace tw

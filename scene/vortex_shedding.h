#pragma once
#include <optional>

#include "scene/scene.h"

namespace tw {

/// What a run takes to shed the vortices of a blunt section that lies under water in a stream, and what this scene has
/// less of: a note where nothing is missing, else a warning. Nothing where no regular shedding is expected. With the
/// height D of the section, Re = U D/nu:
///
///   above Re 47 the wake is unstable, and it sheds D/(0.2 U) apart (Williamson 1996,
///   doi:10.1146/annurev.fl.28.010196.002401); up to 1e5, where the boundary layer begins to be turbulent;
///   the boundary layer where the stream meets the section is 2.4 sqrt(nu/a) thick, a = 4 U/D (Schlichting, Boundary-Layer
///   Theory, chapter 5): 1.2 D/sqrt(Re), of which five spacings are asked, as of the layer of a plate;
///   the sides are at least 8 D away (Behr et al. 1995, doi:10.1016/0045-7825(94)00736-7); here floor and still water.
///
/// The effects have to be planned.
std::optional<Finding> check_vortex_shedding(const Scene& scene);

}  // namespace tw

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
/// None of these sources was at hand to check the numbers. Secondary ones agree with the first line: the tutorial
/// Inc_Von_Karman of SU2, which cites Williamson 1996, has about Re 49; zCFD's guide has 0.179 to 0.182 measured at Re
/// 150. For drag and shedding at Re 200 no value could be confirmed, so none is asked of a run.
///
/// The effects have to be planned.
std::optional<Finding> check_vortex_shedding(const Scene& scene);

}  // namespace tw

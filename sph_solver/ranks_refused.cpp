#include "sph_solver/ranks_refused.h"

#include <fmt/format.h>

#include "base/errors.h"
#include "sph_solver/on_gpu.h"

namespace tw {

void refuse_ranks(const Scene& scene, int ranks) {
    if (ranks > 1 && gpu_wanted(scene))
        throw InputError(
            fmt::format("{}: {} ranks and a GPU do not go together yet: give --device cpu, or run it in one process",
                        scene.place_of("run.device"), ranks));
}

}  // namespace tw

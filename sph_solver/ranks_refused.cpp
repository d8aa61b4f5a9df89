#include "sph_solver/ranks_refused.h"

#include <fmt/format.h>

#include "base/errors.h"

namespace tw {

std::string why_not_over_ranks(const Scene& scene) {
    if (!scene.sph.gate_point.empty())
        return "the spray gate: what hangs together is found by a search through all particles";
    return {};
}

void refuse_ranks(const Scene& scene, int ranks) {
    if (ranks <= 1) return;
    if (const std::string why = why_not_over_ranks(scene); !why.empty())
        throw InputError(
            fmt::format("{}: {} ranks cannot share the particles yet where a scene has {}; run it in one "
                        "process with --threads",
                        scene.file.string(), ranks, why));
}

}  // namespace tw

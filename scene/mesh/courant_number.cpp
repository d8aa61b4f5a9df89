#include "scene/mesh/courant_number.h"

#include <algorithm>

#include "scene/box/inlet_wave.h"
#include "scene/box/tank_wave.h"
#include "scene/mesh/mesh_cells.h"

namespace tw {
namespace {

/// A wave that enters with a faster stream is soon carried past: a 250th of its period of encounter is short
/// enough a step (docs/results/wave_in_stream.md#streams-faster-than-the-wave). The same for all scales of a scene.
double courant_of_entering_wave(const Scene& scene) {
    const double step = wave_scales(scene).period / 250, size = scene.resolution.near_hull / scene.resolution.scale;
    return std::clamp(scene.motion.speed * step / size, 0.15, 0.5);
}

}  // namespace

double default_courant(const Scene& scene) {
    // Implicit Euler flattens a wave by its steps: from 0.05 to 0.15 keep it (Larsen, Fuhrman & Roenby, Coastal Eng. J.
    // 61 (2019) 18). Beside a hull or body of two dimensions cells are smaller than those of the wave, whose steps stay
    // what they are without it.
    const bool flat = scene.domain.dimensions == 2;
    if (scene.has_wave())
        return (inlet_wave(scene) ? courant_of_entering_wave(scene) : 0.15) *
               (flat ? scene.resolution.near_hull / finest_cell(scene) : 1);
    // Measured: forces of a hull in a steady stream are the same at 4 as at 1; a splash is not.
    return scene.motion.kind == Motion::Kind::stream ? 4 : 1;
}

}  // namespace tw

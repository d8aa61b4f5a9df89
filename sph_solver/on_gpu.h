#pragma once
#include <string>

#include "scene/scene.h"
#include "sph_solver/sweeps/passes.h"

namespace tw {

class Simulation;

/// Particle runs on a GPU (cuda).

/// Whether this program has the kernels.
bool built_for_gpu();
/// Memory of a GPU for so many particles and dummies of one or of several sizes, with lists and room to grow [B].
double bytes_on_gpu(double particles, bool several_sizes);
/// Why this machine has no GPU that can be used; empty: it has.
std::string why_no_gpu_here();
/// As its maker calls it; empty: there is none.
std::string gpu_name();
/// Its name, driver and memory, in a line; throws InputError where there is none.
std::string gpu_in_words();

/// What it was measured to do at most: arithmetic in single precision, and reading what its second cache holds.
std::string gpu_peaks_in_words();

/// Whether a scene's `[run] device` and this machine say that a GPU makes the steps. Throws InputError with the reason
/// where one is asked for by "gpu" and is not here.
bool gpu_wanted(const Scene& scene);
/// A line of the GPU that will make a scene's steps; empty: none will. Throws as `gpu_wanted`.
std::string gpu_line(const Scene& scene);
/// What the host beside a GPU makes lists and samples with: groups have eight particles there.
const Passes& passes_beside_gpu();
/// The GPU's name; from now on it makes the steps.
std::string leave_steps_to_gpu(Simulation& simulation);

}  // namespace tw

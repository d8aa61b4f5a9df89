#pragma once
#include <string>

#include "scene/scene.h"
#include "sph_solver/pair_loops/passes.h"

namespace tw {

class Comm;
class Simulation;

/// Particle runs on a GPU (cuda). Of several ranks each has one of its own: that with the number of the rank among
/// those of its machine, counted on from the first one after the last.

/// Whether this program has the kernels.
bool built_for_gpu();
/// Memory of a GPU for so many particles and dummies of one or of several sizes, with lists and room to grow [B].
double bytes_on_gpu(double particles, bool several_sizes);
/// Why this machine has no GPU that can be used; empty: it has.
std::string why_no_gpu_here();
/// As its maker calls it; empty: there is none.
std::string gpu_name();
double gpu_memory();  ///< all of it [B]; 0: there is none
int gpu_count();      ///< that can be used here
/// Its name, driver and memory, in a line; throws InputError where there is none.
std::string gpu_in_words();

/// What it was measured to do at most: arithmetic in single precision, and reading what its second cache holds.
std::string gpu_peaks_in_words();

/// Whether a scene's `[run] device` and this machine say that a GPU makes the steps. "auto" says so where there is one
/// with memory for the particles that are predicted. Throws InputError with the reason where one is asked for by "gpu"
/// and is not here. `sizes`: what predict_sizes says of the scene, where it is known. Of several ranks that of this
/// one: it may be another elsewhere.
bool gpu_wanted(const Scene& scene, const Prediction* sizes = nullptr);
/// A line of the GPU that will make a scene's steps, or that "auto" leaves alone for its memory; empty: there is none,
/// or none was asked for. Throws as `gpu_wanted`.
std::string gpu_line(const Scene& scene, const Prediction* sizes = nullptr);
/// What the host beside a GPU makes lists and samples with: clusters have eight particles there.
const Passes& passes_beside_gpu();
/// What keeps a simulation from the GPU here: too little of its memory is free; empty: nothing. It opens the GPU. Of
/// several ranks this one's.
std::string why_no_room_on_gpu(const Simulation& simulation);
/// The GPU's name; from now on it makes the steps. Throws InputError where there is no room.
std::string leave_steps_to_gpu(Simulation& simulation);
/// How the ranks here share the GPUs, in a line; empty: there is one rank.
std::string gpus_of_ranks(const Comm& ranks);

}  // namespace tw

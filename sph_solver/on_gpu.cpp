#include "sph_solver/on_gpu.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "base/errors.h"
#include "scene/refined_places.h"
#include "sph_solver/backend/variants.h"
#include "sph_solver/parallel/comm.h"
#include "sph_solver/simulation.h"
#ifdef TWINWAKE_CUDA
#include "sph_solver/cuda/peaks.h"
#include "sph_solver/levels/on_device.h"
#endif

namespace tw {

namespace {

/// What of all particles one of this machine's GPUs has to hold: of several ranks each has copies of others' beside its
/// own (a third of a million particles each, docs/decisions/067-ranks.md), and several may share it.
double share_of_gpu(const Comm& ranks) {
    if (!ranks.many()) return 1;
    constexpr double with_copies = 1.4;
    const int gpus = std::max(1, gpu_count()), on_one = (ranks.size_here() + gpus - 1) / gpus;
    return std::min(1.0, with_copies / ranks.size()) * on_one;
}

/// Why the memory of the GPU here is too small for the particles that a scene is predicted to have; empty: it is not.
std::string why_too_small(const Scene& scene, const Prediction* sizes) {
    const Prediction p = sizes ? *sizes : predict_sizes(scene);
    const double particles = p.most_particles + p.air_particles, share = share_of_gpu(Comm::world()),
                 here = share * particles,
                 needed = bytes_on_gpu(here + p.wall_particles, sizes_of_particles(scene) > 1), there = gpu_memory();
    if (needed <= there) return "";
    return fmt::format("{} has {:.3g} GB of memory, and {:.3g} particles need {:.3g} GB there", gpu_name(), there / 1e9,
                       here, needed / 1e9);
}

}  // namespace

double bytes_on_gpu(double particles, bool several_sizes) {
    // Measured were 300 to 500 with one size, the more the longer the kernel reaches; what the edges ask for comes on
    // top.
    return particles * (several_sizes ? 900 : 600);
}

bool gpu_wanted(const Scene& scene, const Prediction* sizes) {
    if (scene.run.device == "cpu") return false;
    const std::string why_not = why_no_gpu_here();
    if (!why_not.empty() && scene.run.device == "gpu")
        throw InputError(fmt::format(
            "{}: [run] device = \"gpu\": {}; leave the key out, or say \"auto\" for a GPU where there is one",
            scene.file.string(), why_not));
    return why_not.empty() && (scene.run.device == "gpu" || why_too_small(scene, sizes).empty());
}

std::string gpu_line(const Scene& scene, const Prediction* sizes) {
    if (gpu_wanted(scene, sizes)) {
        const std::string of_ranks = gpus_of_ranks(Comm::world());
        return "GPU: " + gpu_in_words() + (of_ranks.empty() ? "" : "; " + of_ranks) + "\n";
    }
    if (scene.run.device == "cpu" || !why_no_gpu_here().empty()) return "";
    return "GPU: left alone: " + why_too_small(scene, sizes) + "; this processor makes the steps\n";
}

const Passes& passes_beside_gpu() {
    constexpr int lanes = 8;
    for (const Passes* p : runnable_passes())
        if (p->lanes == lanes) return *p;
    throw std::logic_error("no variant of the pair loops has eight lanes");
}

#ifdef TWINWAKE_CUDA

bool built_for_gpu() { return true; }
std::string why_no_gpu_here() { return cuda::Device::reason_against(); }

std::string gpu_name() { return cuda::Device::name_here(); }
double gpu_memory() { return cuda::Device::memory_here(); }
int gpu_count() { return cuda::Device::count_here(); }

std::string gpu_in_words() {
    const auto device = cuda::Device::open(Comm::world().rank_here());
    const std::string among =
        device->of() == 1 ? ""
                          : fmt::format("; number {} of {}, the first that can be used: CUDA_VISIBLE_DEVICES chooses",
                                        device->number(), device->of());
    return fmt::format("{}, {:.3g} GB, {} multiprocessors, driver {}{}", device->name(), double(device->memory()) / 1e9,
                       device->multiprocessors(), device->driver(), among);
}

std::string gpu_peaks_in_words() {
    const cuda::Peaks peaks = cuda::measure_peaks(*cuda::Device::open());
    return fmt::format("{:.1f} TFLOP/s in single precision, {:.1f} TB/s from the second cache", peaks.flops / 1e12,
                       peaks.cache_bytes / 1e12);
}

namespace {
std::string why_no_room(const cuda::Device& device, const Simulation& simulation) {
    std::int64_t particles = 0;
    std::size_t dummies = 0;
    for (const auto& level : simulation.levels())
        particles += level->fields().count(), dummies += level->system().walls.size();
    const Comm& ranks = simulation.level(0).system().ranks();
    const auto here = static_cast<std::int64_t>(double(particles) * share_of_gpu(ranks));
    const double needed = bytes_on_gpu(double(here) + double(dummies), simulation.levels().size() > 1),
                 free = double(device.free_memory());
    if (needed <= free) return "";
    return fmt::format("{} has {:.3g} GB free, and {} particles need {:.3g} GB there", device.name(), free / 1e9, here,
                       needed / 1e9);
}
std::shared_ptr<cuda::Device> gpu_of(const Simulation& simulation) {
    return cuda::Device::open(simulation.level(0).system().ranks().rank_here());
}
}  // namespace

std::string why_no_room_on_gpu(const Simulation& simulation) { return why_no_room(*gpu_of(simulation), simulation); }

std::string leave_steps_to_gpu(Simulation& simulation) {
    const std::shared_ptr<cuda::Device> device = gpu_of(simulation);
    if (const std::string why = why_no_room(*device, simulation); !why.empty())
        throw InputError(why + ": coarser particles, a smaller domain, or [run] device = \"cpu\"");
    for (std::size_t k = 0; k < simulation.levels().size(); ++k) {
        simulation.level(k).leave_steps_to([&](ParticleSystem& system, RankShare& share) {
            return std::make_unique<LevelOnDevice>(system, share, device);
        });
    }
    return device->name();
}

std::string gpus_of_ranks(const Comm& ranks) {
    if (!ranks.many()) return "";
    const int gpus = gpu_count(), here = ranks.size_here();
    if (here <= gpus) return fmt::format("each of {} ranks here has a GPU of its own, of {}", here, gpus);
    return fmt::format(
        "{} ranks here share {} GPU{}, which make{} the steps of one rank after the other: as many ranks "
        "as GPUs would do",
        here, gpus, gpus == 1 ? "" : "s", gpus == 1 ? "s" : "");
}

#else

bool built_for_gpu() { return false; }
std::string why_no_gpu_here() { return "this twinwake was built without kernels; install clang and build it anew"; }
std::string gpu_peaks_in_words() { throw InputError(why_no_gpu_here()); }
std::string gpu_name() { return {}; }
double gpu_memory() { return 0; }
int gpu_count() { return 0; }
std::string gpus_of_ranks(const Comm&) { return {}; }
std::string gpu_in_words() { throw InputError(why_no_gpu_here()); }
std::string why_no_room_on_gpu(const Simulation&) { throw InputError(why_no_gpu_here()); }
std::string leave_steps_to_gpu(Simulation&) { throw InputError(why_no_gpu_here()); }

#endif

}  // namespace tw

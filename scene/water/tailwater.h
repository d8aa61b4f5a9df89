#pragma once
#include <optional>

#include "scene/scene.h"

namespace tw {

/// The water behind what a stream passes, a weir, a sluice gate or a hydraulic jump, where its depth is another than
/// ahead ([domain] downstream). As much water leaves as enters:
///
///   U_d h_d = U h
///
/// Below the critical speed U_d^2 = g h_d the outlet draws to U_d, so that the depth is held; above it the water leaves
/// as it comes.
struct Tailwater {
    double depth = 0;      ///< h_d [m]
    double speed = 0;      ///< U_d [m/s]
    double level = 0;      ///< of its surface, z [m]
    double begins = 0;     ///< at the start the water is as deep as that behind this x [m]
    bool is_slow = false;  ///< below the critical speed
};
/// None: the stream is as deep behind as ahead. `begins`: the middle of what stands highest on the bed or hangs into
/// the water, or that of the box. Its domain has to be known, its weight may be off.
std::optional<Tailwater> tailwater(const Scene& scene);

/// The faster of the streams ahead and behind [m/s].
double fastest_stream(const Scene& scene);

/// Throws InputError where [domain] downstream stands in a scene that has no such water, or where its surface lies
/// beyond the box.
void check_tailwater(const Scene& scene);

}  // namespace tw

#pragma once
#include <memory>
#include <vector>

#include "base/vec3.h"

namespace tw {

class Effect;

/// Layers along faces of the domain that draw the velocity towards that of the undisturbed water, so that waves die out
/// before they meet the face:
///
///   du/dt -= strength s^2 (u - u_undisturbed),   s = depth in the layer over its width, 0 inside to 1 at the face
///
/// The undisturbed water moves with the stream (or rests). `velocity` moves the layers themselves, for a body that is
/// towed through the tank.
struct DampingLayers {
    struct Layer {
        int axis = 0;       ///< 0 x, 1 y, 2 z
        bool high = false;  ///< at the face of larger coordinate
        double width = 0;   ///< [m]
    };
    std::vector<Layer> layers;
    double strength = 0;           ///< [1/s]
    Vec3 velocity = Vec3::Zero();  ///< of the layers [m/s]
};
std::unique_ptr<Effect> make_effect(const DampingLayers& options);

}  // namespace tw

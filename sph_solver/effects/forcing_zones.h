#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "scene/box/forcing_zones.h"

namespace tw {

class Effect;

/// Zones along faces of the domain that draw the velocity towards that of the undisturbed water, so that waves die out
/// before they meet the face (scene/box/forcing_zones.h has the equation and its source):
///
///   du/dt += gamma s^2 (u_ref - u),   s from 0 at a zone's beginning to 1 at the face
///
/// u_ref is the velocity that the stream has at that time, of water of another depth behind the share of it that it
/// keeps, or rest, or that of the scene's wave; where zones overlap the largest gamma s^2 counts. While the stream
/// starts, the water behind is accelerated by its share too (domain/stream.h).
struct ZoneForcing {
    std::vector<ForcingZone> zones;
    std::optional<WaveSum> wave = {};        ///< that some of the zones make; none: they make no regular one
    std::optional<WaveComponents> sea = {};  ///< likewise, a sum of linear waves
};
std::unique_ptr<Effect> make_effect(const ZoneForcing& options);

}  // namespace tw

#pragma once
#include <string>
#include <vector>

#include "stability/map.h"

namespace tw {

/// The maps that were run, for a terminal, for programs and for a browser.
std::string stability_text(const std::vector<StabilityMap>& maps);
std::string stability_json(const std::vector<StabilityMap>& maps, bool quick);
/// One page that loads nothing from anywhere.
std::string stability_html(const std::vector<StabilityMap>& maps, bool quick);
/// All maps as one picture that stands alone.
std::string stability_svg(const std::vector<StabilityMap>& maps);

/// How many cells are stable, warned, failed.
struct StabilityCounts {
    std::size_t stable = 0, warned = 0, failed = 0;
};
StabilityCounts count(const std::vector<StabilityMap>& maps);

}  // namespace tw

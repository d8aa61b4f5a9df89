#include "scene/effects/part.h"

#include <fmt/format.h>

namespace tw {

EffectChoice EffectQuestion::choice(bool automatic) const {
    EffectChoice c;
    c.forced = asked.has_value();
    c.on = asked.value_or(automatic);
    return c;
}

std::string influence(const std::string& drag, const std::string& lift, const std::string& splash,
                      const std::string& remark) {
    return fmt::format("drag: {}; lift: {}; splash: {}{}", drag, lift, splash, remark.empty() ? "" : "; " + remark);
}

std::vector<EffectBound> equal_shares(const std::vector<std::string>& kinds, double share, const std::string& source) {
    std::vector<EffectBound> bounds;
    for (const std::string& of : kinds) bounds.push_back({.of = of, .below = share, .above = share, .source = source});
    return bounds;
}

}  // namespace tw

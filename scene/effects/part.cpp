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

}  // namespace tw

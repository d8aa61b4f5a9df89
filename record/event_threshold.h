#pragma once
#include <string>

namespace tw {

/// The number that says above which value the peak of a probe ("pressure", "height") in waves is an event: a slam,
/// water on a deck.
inline std::string event_threshold(const std::string& table, const std::string& name) {
    return "event_above_" + table + "_" + name;
}

}  // namespace tw

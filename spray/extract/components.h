#pragma once
#include "spray/extract/element.h"

namespace tw::spray {

/// Which elements hang together: two are linked where they are no farther apart than `link` times the mean of their
/// sizes; a component is what links connect. Components are numbered by falling volume: 0 is the body of water.
/// Returns the number of each element. Throws InputError: `link` not above 0, an element that is not finite or whose
/// size is not above 0.
std::vector<int> components(std::span<const Element> elements, double link);

}  // namespace tw::spray

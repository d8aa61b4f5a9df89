#pragma once
#include <string>
#include <vector>

namespace tw {

/// The kinds of quantities (record/effect_choice.h) that a quantity is one of, by its name: what an effect says of the
/// first that it knows counts. Empty: no plan speaks of it.
std::vector<std::string> kinds_of(std::string quantity);

}  // namespace tw

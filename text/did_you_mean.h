#pragma once
#include <string>
#include <vector>

namespace tw {

/// "; did you mean 'draft'?" when one of `known` is near `word`, else empty.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& known);

}  // namespace tw

#pragma once
#include <string>
#include <string_view>

namespace tw {

/// Text for HTML or SVG content and quoted attributes: & < > " ' become entities, control characters and broken UTF-8
/// become U+FFFD.
std::string escaped(std::string_view text);

}  // namespace tw

#pragma once
#include <string>
#include <string_view>

namespace tw {

/// Text for HTML or SVG content and quoted attributes: & < > " ' become entities, control characters and broken UTF-8
/// become U+FFFD.
std::string escaped(std::string_view text);

/// A file name as one word of a POSIX shell: readers paste the command.
std::string shell_word(const std::string& name);

/// Text for a terminal: control characters but the line feed become ?, so that no record or table steers it.
std::string for_terminal(std::string text);

}  // namespace tw

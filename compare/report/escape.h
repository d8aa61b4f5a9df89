#pragma once
#include <string>
#include <string_view>

namespace tw {

/// Text for HTML or SVG content and quoted attributes: & < > " ' become entities, control characters and broken UTF-8
/// become U+FFFD.
std::string escaped(std::string_view text);

/// One word of a POSIX shell, quoted where it needs to be: readers paste the command.
std::string shell_word(const std::string& word);
/// A file name as such a word: one that begins with a dash is no option.
std::string shell_file(const std::string& name);

/// Text for a terminal: control characters but line feed and tab, what turns the direction of writing, and broken UTF-8
/// become ?, so that no scene, record or table steers it.
std::string for_terminal(std::string_view text);

/// Bytes for a data URL or a script.
std::string base64(std::string_view bytes);

}  // namespace tw

#pragma once
#include <cstddef>
#include <filesystem>
#include <string>

namespace tw {

/// Of a document that people write: what is larger is another file [bytes].
inline constexpr std::size_t largest_document = 8'000'000;

/// Whole content of a file of at most so many bytes. Throws InputError when it cannot be read, is a device, or has more.
std::string read_text_within(const std::filesystem::path& path, std::size_t most);

/// Throws InputError for a folder or a device, of which a reader line by line would not come to an end.
void refuse_no_file(const std::filesystem::path& path);

/// Makes a folder of ours within another. Throws RunError where it cannot be made, or is a symbolic link: what it holds
/// would be written somewhere else.
void make_own_folder(const std::filesystem::path& folder);

}  // namespace tw

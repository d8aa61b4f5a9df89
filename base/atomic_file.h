#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace tw {

/// Writes a file so that a reader sees either the old or the whole new content: `write(tmp)` fills a temporary
/// name in the same folder, which is flushed to disk (fsync) and renamed. Throws RunError naming the path and
/// the system's reason (disk full, no permission); the temporary file is removed.
void write_atomically(const std::filesystem::path& path,
                      const std::function<void(const std::filesystem::path& tmp)>& write);
void write_text_atomically(const std::filesystem::path& path, std::string_view text);

/// For tests: called before each step of the above into which a crash may fall.
extern void (*before_write_step)();

/// Whole content of a file; throws InputError when it cannot be read.
std::string read_text(const std::filesystem::path& path);

}  // namespace tw

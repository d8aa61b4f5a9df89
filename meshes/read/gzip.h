#pragma once
#include <filesystem>
#include <string>

namespace tw {

/// The content of a gzip file, `compressed` being its bytes. Throws InputError naming the file: not gzip, truncated,
/// damaged, or larger than `largest` bytes when unpacked.
std::string unpacked(const std::filesystem::path& file, const std::string& compressed, std::size_t largest);

/// A file in memory with a path of its own, for readers that take nothing but a path. Gone with this object.
class MemoryFile {
public:
    /// Throws RunError when the memory cannot be had.
    explicit MemoryFile(const std::string& content);
    ~MemoryFile();
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

private:
    int descriptor_;
};

}  // namespace tw

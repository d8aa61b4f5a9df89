#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tw::readers {

/// Bytes that somebody hands to the program as a file.
class Input {
public:
    Input(std::string_view bytes, std::filesystem::path folder) : bytes_(bytes), folder_(std::move(folder)) {}
    std::string_view bytes() const { return bytes_; }
    /// Written under that name below this process's own folder.
    std::filesystem::path file(const std::string& name) const { return file(name, bytes_); }
    std::filesystem::path file(const std::string& name, std::string_view content) const;

private:
    std::string_view bytes_;
    std::filesystem::path folder_;
};

/// One reader. `read` may throw InputError or RunError, and nothing else; it crashes and hangs never.
struct Reader {
    std::string name;  ///< and its folder below corpus/
    void (*read)(const Input& input);
};
const std::vector<Reader>& all_readers();

/// Gives the input to the reader. "": read; else the words in which it was refused.
std::string feed(const Reader& reader, const Input& input);

}  // namespace tw::readers

#include "base/in_words.h"

#include <filesystem>
#include <new>

namespace tw {

std::string in_words(const std::exception& e) {
    if (const auto* files = dynamic_cast<const std::filesystem::filesystem_error*>(&e)) {
        std::string places = files->path1().string();
        if (!files->path2().empty()) places += " to " + files->path2().string();
        return (places.empty() ? "a file" : places) + ": " + files->code().message();
    }
    if (dynamic_cast<const std::bad_alloc*>(&e)) return "out of memory";
    const std::string text = e.what();
    constexpr const char* of_json =
        "[json.exception.";  // "[json.exception.parse_error.101] parse error at line 1, ..."
    const std::size_t end = text.starts_with(of_json) ? text.find("] ") : std::string::npos;
    return end == std::string::npos ? text : text.substr(end + 2);
}

}  // namespace tw

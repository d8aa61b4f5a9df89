#include "base/read_file.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "base/errors.h"

namespace tw {
namespace fs = std::filesystem;

void make_own_folder(const fs::path& folder) {
    std::error_code error;
    if (fs::is_symlink(folder, error))
        throw RunError(folder.string() +
                       ": is a symbolic link, through which nothing is written; remove it, or choose "
                       "another folder");
    fs::create_directories(folder, error);
    if (error) throw RunError(folder.string() + ": the folder cannot be made: " + error.message());
}

void refuse_no_file(const fs::path& path) {
    std::error_code none;
    const bool device = fs::is_character_file(path, none) || fs::is_block_file(path, none);
    if (device || fs::is_directory(path, none))
        throw InputError(path.string() + ": cannot be read: it is a " + (device ? "device" : "folder") +
                         "; expected a file");
}

std::string read_text_within(const fs::path& path, std::size_t most) {
    refuse_no_file(path);
    const auto refuse = [&](const std::string& why) { throw InputError(path.string() + ": cannot be read: " + why); };
    errno = 0;
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> in(std::fopen(path.c_str(), "rbe"), std::fclose);
    if (!in) refuse(std::strerror(errno));
    std::string text;
    std::array<char, 1 << 16> piece{};
    while (const std::size_t n = std::fread(piece.data(), 1, piece.size(), in.get())) {
        text.append(piece.data(), n);
        if (text.size() > most)
            refuse("it has more than " + std::to_string(most / 1000000) + " MB; is it the right file?");
    }
    if (std::ferror(in.get()) != 0) refuse(std::strerror(errno));
    return text;
}

}  // namespace tw

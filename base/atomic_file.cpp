#include "base/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "base/errors.h"
#include "base/read_file.h"

namespace tw {
namespace fs = std::filesystem;

namespace {
[[noreturn]] void fail(const fs::path& path, const std::string& why) {
    throw RunError(path.string() + ": cannot be written: " + why);
}
void sync(const fs::path& path, int flags) {
    const int fd = ::open(path.c_str(), flags);
    if (fd < 0) fail(path, std::strerror(errno));
    const int rc = ::fsync(fd);
    const int error = errno;
    ::close(fd);
    if (rc != 0) fail(path, std::strerror(error));
}
}  // namespace

void (*before_write_step)() = nullptr;

void write_atomically(const fs::path& path, const std::function<void(const fs::path&)>& write) {
    const fs::path tmp = path.string() + ".tmp";
    const auto next_step = [] {
        if (before_write_step) before_write_step();
    };
    try {
        next_step();
        fs::remove(tmp);  // what an interrupted run has left; a link to somewhere else is not followed
        write(tmp);
        next_step();
        sync(tmp, O_RDONLY);
        next_step();
        fs::rename(tmp, path);
        next_step();
    } catch (const fs::filesystem_error& e) {
        std::error_code ignored;
        fs::remove(tmp, ignored);
        fail(path, e.code().message());
    } catch (...) {
        std::error_code ignored;
        fs::remove(tmp, ignored);
        throw;
    }
    sync(path.has_parent_path() ? path.parent_path() : fs::path("."), O_RDONLY | O_DIRECTORY);
}

void write_text_atomically(const fs::path& path, std::string_view text) {
    write_atomically(path, [&](const fs::path& tmp) {
        std::FILE* out = std::fopen(tmp.c_str(), "wbxe");  // x: what is there already is not written into
        if (out == nullptr) fail(path, std::strerror(errno));
        const bool whole = std::fwrite(text.data(), 1, text.size(), out) == text.size();
        const int error = errno;
        if (std::fclose(out) != 0) fail(path, std::strerror(errno));
        if (!whole) fail(path, std::strerror(error));
    });
}

std::string read_text(const fs::path& path) { return read_text_within(path, std::size_t{4} << 30); }

}  // namespace tw

#include "base/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "base/errors.h"

namespace tw {
namespace fs = std::filesystem;

namespace {
constexpr const char* lent = "TWINWAKE_LENT_LOCK";  ///< the file descriptor of a parent's lock

bool same_file(int a, int b) {
    struct stat of_a {
    }, of_b{};
    return ::fstat(a, &of_a) == 0 && ::fstat(b, &of_b) == 0 && of_a.st_dev == of_b.st_dev && of_a.st_ino == of_b.st_ino;
}

/// A lock belongs to the open file, which parent and child share, so the lent one is had already; -1: `fd`'s was not
/// lent.
int lent_instead_of(int fd) {
    const char* const text = std::getenv(lent);
    const int parent = text ? std::atoi(text) : -1;
    return parent > STDERR_FILENO && same_file(fd, parent) ? ::fcntl(parent, F_DUPFD_CLOEXEC, 0) : -1;
}
}  // namespace

FolderLock::FolderLock(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw InputError(folder.string() + ": the folder cannot be made: " + error.message());
    const fs::path file = folder / ".lock";
    fd_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0644);
    if (fd_ < 0) throw InputError(file.string() + ": cannot be opened: " + std::strerror(errno));
    if (const int parents = lent_instead_of(fd_); parents >= 0) {
        ::close(fd_);
        fd_ = parents;
    }
    if (::flock(fd_, LOCK_EX | LOCK_NB) == 0) return;
    const int why = errno;
    ::close(fd_);
    if (why == EWOULDBLOCK)
        throw InputError(folder.string() + ": another run is using it; wait for it or choose another folder");
    throw InputError(file.string() + ": cannot be locked: " + std::strerror(why));
}

FolderLock::~FolderLock() { ::close(fd_); }

std::string FolderLock::lend() {
    ::fcntl(fd_, F_SETFD, 0);  // stays open in a program that the child starts
    return std::string(lent) + "=" + std::to_string(fd_);
}

}  // namespace tw

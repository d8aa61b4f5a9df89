#include "base/folder_lock.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

#include "base/errors.h"

namespace tw {
namespace folder_lock_test {
namespace fs = std::filesystem;

class Locked : public testing::Test {
protected:
    const fs::path folder = fs::temp_directory_path() / "locked";

    bool is_free() const {
        try {
            const FolderLock lock(folder);
            return true;
        } catch (const InputError&) { return false; }
    }
};

TEST_F(Locked, IsHeldWhileTheLockLives) {
    {
        const FolderLock lock(folder);
        EXPECT_FALSE(is_free());
    }
    EXPECT_TRUE(is_free());
}

/// The lender ends before the child that works for it, as one that was killed: the folder stays held.
TEST_F(Locked, LentToAChildIsHeldUntilBothHaveEnded) {
    int go_on[2], ready[2];
    ASSERT_EQ(pipe(go_on) + pipe(ready), 0);
    pid_t child = 0;
    char byte = 0;
    {
        FolderLock lock(folder);
        std::string entry = lock.lend();
        child = fork();
        if (child == 0) {
            putenv(entry.data());
            try {
                const FolderLock same(folder);
                byte = 'y';
            } catch (const InputError&) { byte = 'n'; }
            const bool told = write(ready[1], &byte, 1) == 1;
            _exit(told && read(go_on[0], &byte, 1) == 1 ? 0 : 1);
        }
        ASSERT_EQ(read(ready[0], &byte, 1), 1);
        EXPECT_EQ(byte, 'y') << "the child is refused what was lent to it";
        EXPECT_FALSE(is_free());
    }
    EXPECT_FALSE(is_free()) << "the child works on";
    ASSERT_EQ(write(go_on[1], &byte, 1), 1);
    waitpid(child, nullptr, 0);
    EXPECT_TRUE(is_free());
    for (const int fd : {go_on[0], go_on[1], ready[0], ready[1]}) close(fd);
}

TEST_F(Locked, OfAnotherFolderIsNotTheOneThatWasLent) {
    FolderLock other(folder / "other");
    std::string entry = other.lend();
    const FolderLock lock(folder);
    putenv(entry.data());
    EXPECT_FALSE(is_free());
    unsetenv("TWINWAKE_LENT_LOCK");
}

TEST_F(Locked, ALinkInThePlaceOfItsFileIsRefused) {
    fs::create_directories(folder / "odd");
    fs::create_symlink(folder / "elsewhere", folder / "odd/.lock");
    EXPECT_THROW(const FolderLock lock(folder / "odd"), InputError);
    EXPECT_FALSE(fs::exists(folder / "elsewhere"));
}

}  // namespace folder_lock_test
}  // namespace tw

#pragma once
#include <filesystem>
#include <string>

namespace tw {

/// Holds `folder/.lock` (flock) while it lives: two programs never write into one folder. Throws InputError where
/// another process holds it. A study holds its own folder, and each run in it the run's.
class FolderLock {
public:
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    /// NAME=VALUE for the environment of a child process, forked or started, that works in this folder on behalf of
    /// this one: a FolderLock of the folder there is this same lock, and the folder is free when the last of them and
    /// this one have ended.
    std::string lend();

private:
    int fd_ = -1;
};

}  // namespace tw

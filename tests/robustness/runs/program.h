#pragma once
#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace tw::test {

/// The `twinwake` program as a user starts it, without a shell in between.
class Program {
public:
    /// Starts at once; output and errors go to one file. `largest_file` > 0: no file may grow beyond this [bytes], as on
    /// a full disk. `program`: another one, its path; empty: twinwake.
    explicit Program(const std::vector<std::string>& arguments, const std::filesystem::path& working_folder,
                     long largest_file = 0, const std::filesystem::path& program = {});
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    /// Waits for its end: exit status, or -signal.
    int wait();
    bool running();
    void kill_hard();  ///< SIGKILL
    pid_t pid() const { return pid_; }
    std::string output() const;

private:
    pid_t pid_ = -1;
    int status_ = 0;
    std::filesystem::path output_;
};

/// An empty folder of this test's own, removed with everything in it at the end.
class ScratchFolder {
public:
    explicit ScratchFolder(const std::string& name);
    ~ScratchFolder();
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// Polls until `happened`, for at most `seconds`.
bool wait_until(const std::function<bool()>& happened, double seconds);

/// Writes a small two-dimensional collapsing column; a run of one simulated second takes some seconds.
std::filesystem::path write_small_scene(const std::filesystem::path& file, double duration,
                                        const std::string& title = "small column");

}  // namespace tw::test

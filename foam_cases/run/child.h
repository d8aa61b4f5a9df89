#pragma once
#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tw {

/// A program and its arguments, started without a shell: no character in them has a meaning.
struct Command {
    std::filesystem::path program;
    std::vector<std::string> arguments;
};

struct Ended {
    int status = 0;  ///< exit status; 128 + signal when a signal ended it
    int signal = 0;
    double wall = 0, cpu = 0;  ///< [s], its own children included
    double peak_memory = 0;    ///< [bytes], of the largest process
    bool ok() const { return status == 0; }
};

/// A child process in a process group of its own; its output is appended to a log file. It is ended with its parent,
/// whatever ends that.
class ChildProcess {
public:
    /// `environment`: "NAME=value" each. Throws RunError when the program cannot be started.
    ChildProcess(const Command& command, const std::vector<std::string>& environment,
                 const std::filesystem::path& folder, const std::filesystem::path& log);
    ~ChildProcess();  ///< kills what still runs
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    std::optional<Ended> poll();  ///< set once it has ended
    Ended wait();
    void signal_group(int number);
    pid_t pid() const { return pid_; }

private:
    std::optional<Ended> collect(int options);
    pid_t pid_ = -1;
    double started_ = 0;
    std::optional<Ended> ended_;
};

double wall_clock();  ///< monotonic [s]

/// "Floating point exception (a division by zero or an overflow in the flow)" and the like.
std::string signal_in_words(int number);

}  // namespace tw

#include "foam_cases/run/child.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>

#include "base/errors.h"

namespace tw {

double wall_clock() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

namespace {
std::vector<char*> pointers(const std::vector<std::string>& texts) {
    std::vector<char*> p;
    for (const std::string& t : texts) p.push_back(const_cast<char*>(t.c_str()));
    p.push_back(nullptr);
    return p;
}
}  // namespace

ChildProcess::ChildProcess(const Command& command, const std::vector<std::string>& environment,
                           const std::filesystem::path& folder, const std::filesystem::path& log)
    : started_(wall_clock()) {
    const std::string program = command.program.string(), cwd = folder.string();
    std::vector<std::string> texts{program};
    texts.insert(texts.end(), command.arguments.begin(), command.arguments.end());
    const std::vector<char*> argv = pointers(texts), envp = pointers(environment);
    const int out = ::open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
    if (out < 0) throw RunError(log.string() + ": cannot be written: " + std::strerror(errno));
    int report[2];  // the child writes errno here when it cannot start the program
    if (::pipe2(report, O_CLOEXEC) != 0) {
        ::close(out);
        throw RunError(std::string("no pipe for a child process: ") + std::strerror(errno));
    }
    const pid_t parent = ::getpid();
    pid_ = ::fork();
    if (pid_ == 0) {  // only async-signal-safe calls from here to execve
        ::setpgid(0, 0);
        ::prctl(PR_SET_PDEATHSIG, SIGTERM);
        const int null = ::open("/dev/null", O_RDONLY);
        bool ready = ::getppid() == parent && ::chdir(cwd.c_str()) == 0 && null >= 0;
        ready = ready && ::dup2(null, 0) >= 0 && ::dup2(out, 1) >= 0 && ::dup2(out, 2) >= 0;
        sigset_t none;
        ::sigemptyset(&none);
        ::sigprocmask(SIG_SETMASK, &none, nullptr);
        if (ready) ::execve(program.c_str(), argv.data(), envp.data());
        const int error = errno;
        if (::write(report[1], &error, sizeof error) < 0) ::_exit(126);
        ::_exit(127);
    }
    const int fork_error = errno;
    ::close(out);
    ::close(report[1]);
    int error = pid_ < 0 ? fork_error : 0;
    if (pid_ > 0) {
        ::setpgid(pid_, pid_);  // whichever of the two comes first
        if (::read(report[0], &error, sizeof error) != static_cast<ssize_t>(sizeof error)) error = 0;
    }
    ::close(report[0]);
    if (error != 0) {
        if (pid_ > 0) wait();
        throw RunError(program + ": cannot be started: " + std::strerror(error));
    }
}

ChildProcess::~ChildProcess() {
    if (pid_ > 0 && !ended_) {
        signal_group(SIGKILL);
        collect(0);
    }
}

std::optional<Ended> ChildProcess::collect(int options) {
    if (ended_) return ended_;
    int status = 0;
    rusage used{};
    pid_t got = 0;
    do got = ::wait4(pid_, &status, options, &used);
    while (got < 0 && errno == EINTR);
    if (got == 0) return std::nullopt;
    Ended e;
    e.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    e.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + e.signal;
    if (e.signal == 0 && e.status > 128 && e.status < 160) e.signal = e.status - 128;  // mpirun hands it on this way
    e.wall = wall_clock() - started_;
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    e.cpu = seconds(used.ru_utime) + seconds(used.ru_stime);
    e.peak_memory = 1024.0 * static_cast<double>(used.ru_maxrss);
    ended_ = e;
    return ended_;
}
std::optional<Ended> ChildProcess::poll() { return collect(WNOHANG); }
Ended ChildProcess::wait() { return *collect(0); }
void ChildProcess::signal_group(int number) {
    if (pid_ > 0 && !ended_) ::kill(-pid_, number);
}

std::string signal_in_words(int number) {
    switch (number) {
        case SIGFPE: return "floating point exception: a division by zero or an overflow in the flow";
        case SIGSEGV: return "segmentation fault: a fault of the program or its libraries";
        case SIGABRT: return "abort";
        case SIGKILL: return "killed: by hand, or by the system because memory ran out";
        case SIGTERM: return "terminated from outside";
        case SIGBUS: return "bus error: often a full disk or a vanished file";
        case SIGXFSZ: return "a file grew beyond the allowed size";
        default: return std::string("signal ") + std::to_string(number);
    }
}

}  // namespace tw

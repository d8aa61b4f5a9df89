#include "base/trial.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <exception>
#include <fstream>
#include <new>

#include "base/errors.h"
#include "base/in_words.h"

namespace tw {
namespace {

/// Address space that this process has [bytes].
double mapped_memory() {
    double pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

bool write_all(int to, const std::string& bytes) {
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t n = write(to, bytes.data() + done, bytes.size() - done);
        if (n < 0 && errno != EINTR) return false;
        done += static_cast<std::size_t>(std::max<ssize_t>(n, 0));
    }
    return true;
}

[[noreturn]] void try_here(const std::function<std::string()>& work, const TrialLimits& limits, int answer) {
    for (const int signal : {SIGINT, SIGTERM, SIGALRM, SIGXCPU, SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL})
        std::signal(signal, SIG_DFL);
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    rlimit memory{};
    getrlimit(RLIMIT_AS, &memory);
    memory.rlim_cur = std::min(memory.rlim_max, static_cast<rlim_t>(mapped_memory() + limits.bytes));
    setrlimit(RLIMIT_AS, &memory);
    const auto seconds = static_cast<rlim_t>(std::ceil(limits.processor));
    const rlimit processor{seconds, seconds + 1};
    setrlimit(RLIMIT_CPU, &processor);
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    alarm(static_cast<unsigned>(std::ceil(limits.seconds)));
    std::string fault;
    try {
        _exit(write_all(answer, work()) ? 0 : 1);
    } catch (const std::bad_alloc&) {
        fault = "it asks for more memory than it may have";
    } catch (const std::exception& e) { fault = in_words(e); } catch (...) {
        fault = "an error without a name";
    }
    write_all(answer, fault);
    _exit(1);
}

}  // namespace

std::string answer_of_trial(const std::function<std::string()>& work, const TrialLimits& limits) {
    std::array<int, 2> answer{};
    if (pipe2(answer.data(), O_CLOEXEC) != 0)
        throw RunError(std::string("no pipe to a child: ") + std::strerror(errno));
    const pid_t child = fork();
    if (child == 0) try_here(work, limits, answer[1]);
    close(answer[1]);
    std::string said;
    std::array<char, 1 << 16> piece{};
    for (ssize_t n = 0; child > 0 && (n = read(answer[0], piece.data(), piece.size())) != 0;) {
        if (n < 0 && errno != EINTR) break;
        said.append(piece.data(), static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
    }
    close(answer[0]);
    if (child < 0) throw RunError(std::string("no child process can be made: ") + std::strerror(errno));
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {}
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return said;
    if (WIFEXITED(status) && !said.empty()) throw InputError(said);
    const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    throw InputError(signal == SIGALRM || signal == SIGXCPU ? "it does not come to an end"
                                                            : "its numbers contradict each other");
}

}  // namespace tw

#include "program.h"
#include "test_paths.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

namespace tw::test {

Program::Program(const std::vector<std::string>& arguments, const std::filesystem::path& working_folder,
                 long largest_file, const std::filesystem::path& program) {
    static int number = 0;
    output_ = std::filesystem::temp_directory_path() /
              ("twinwake_output_" + std::to_string(getpid()) + "_" + std::to_string(++number));
    const std::string file = program.empty() ? TWINWAKE_PROGRAM : program.string();
    std::vector<std::string> words{file};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);

    pid_ = fork();
    if (pid_ < 0) throw std::runtime_error("fork failed");
    if (pid_ > 0) return;
    const int in = open("/dev/null", O_RDONLY), out = open(output_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(in, 0);
    dup2(out, 1);
    dup2(out, 2);
    if (chdir(working_folder.c_str()) != 0) _exit(126);
    if (largest_file > 0) {
        signal(SIGXFSZ, SIG_IGN);  // a full disk is an error of write(), not a signal
        const rlimit limit{static_cast<rlim_t>(largest_file), static_cast<rlim_t>(largest_file)};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    execv(file.c_str(), argv.data());
    _exit(127);
}

Program::~Program() {
    if (running()) {
        kill_hard();
        wait();
    }
    std::error_code ignored;
    std::filesystem::remove(output_, ignored);
}

int Program::wait() {
    if (pid_ > 0) {
        waitpid(pid_, &status_, 0);
        pid_ = -1;
    }
    return WIFEXITED(status_) ? WEXITSTATUS(status_) : -WTERMSIG(status_);
}

bool Program::running() {
    if (pid_ > 0 && waitpid(pid_, &status_, WNOHANG) == pid_) pid_ = -1;
    return pid_ > 0;
}

void Program::kill_hard() {
    if (running()) kill(pid_, SIGKILL);
}

std::string Program::output() const {
    std::ifstream file(output_);
    return {std::istreambuf_iterator<char>(file), {}};
}

ScratchFolder::ScratchFolder(const std::string& name)
    : path_(std::filesystem::temp_directory_path() / ("twinwake_" + std::to_string(getpid()) + "_" + name)) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

bool wait_until(const std::function<bool()>& happened, double seconds) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    while (std::chrono::steady_clock::now() < end) {
        if (happened()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return happened();
}

std::filesystem::path write_small_scene(const std::filesystem::path& file, double duration, const std::string& title) {
    std::ofstream out(file);
    out << "title = '''" << title << "'''\n"
        << "[tank]\nsize = [2, 0.02, 1]\n"
        << "[domain]\ndimensions = 2\n"
        << "[[water_block]]\nmin = [0, 0, 0]\nmax = [0.5, 0.02, 0.5]\n"
        << "[resolution]\nnear_hull = 0.01\n"
        << "[sampling]\ninterval = 0.05\n"
        << "[[probe]]\npressure = [0.25, 0, 0.02]\n"
        << "[run]\nmethods = [\"sph\"]\ncheckpoint = 0.05\nduration = " << duration << "\n";
    return file;
}

}  // namespace tw::test

#pragma once
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "test_paths.h"

namespace tw::test {

namespace fs = std::filesystem;

inline std::string content(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

struct Outcome {
    int status = -1;
    std::string out, err;
};

/// A folder of its own for each test, with what a user would do in it.
class Command : public testing::Test {
protected:
    void SetUp() override {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::temp_directory_path() / "twinwake_command_tests" /
                  (std::string(info->test_suite_name()) + "." + info->name());
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        setenv("XDG_CACHE_HOME", (folder_ / "cache").c_str(), 1);  // what runs teach stays in the test
    }
    void TearDown() override {
        if (!HasFailure()) fs::remove_all(folder_);
    }

    fs::path write(const std::string& name, const std::string& text) const {
        fs::create_directories((folder_ / name).parent_path());
        std::ofstream(folder_ / name, std::ios::binary) << text;
        return folder_ / name;
    }

    struct Started {
        pid_t child;
        fs::path out, err;
    };
    /// Starts the program in the test's folder, without a shell. `largest_file` > 0: no file may grow beyond it
    /// [bytes], as on a disk that is full. `standard_output`: a device that takes it instead.
    Started start(std::vector<std::string> arguments, rlim_t largest_file = 0,
                  const char* standard_output = nullptr) const {
        static int number = 0;
        const std::string name = "twinwake_" + std::to_string(getpid()) + "_" + std::to_string(++number);
        const Started s0{0, fs::temp_directory_path() / (name + ".out"), fs::temp_directory_path() / (name + ".err")};
        const pid_t child = fork();
        if (child == 0) {
            if (chdir((folder_ / stands_in_).c_str()) != 0) _exit(126);
            setenv("PWD", (folder_ / stands_in_).c_str(), 1);  // as a shell does
            dup2(standard_output ? open(standard_output, O_WRONLY)
                                 : open(s0.out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600),
                 STDOUT_FILENO);
            dup2(open(s0.err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
            if (largest_file > 0) {
                const rlimit limit{largest_file, largest_file};
                setrlimit(RLIMIT_FSIZE, &limit);
                std::signal(SIGXFSZ, SIG_IGN);  // inherited: writes fail instead of killing
            }
            std::vector<char*> argv{const_cast<char*>(TWINWAKE_PROGRAM)};
            for (std::string& a : arguments) argv.push_back(a.data());
            argv.push_back(nullptr);
            execv(TWINWAKE_PROGRAM, argv.data());
            _exit(127);
        }
        return {child, s0.out, s0.err};
    }
    Outcome finish(const Started& s) const {
        int status = 0;
        waitpid(s.child, &status, 0);
        Outcome o{WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), content(s.out), content(s.err)};
        fs::remove(s.out);
        fs::remove(s.err);
        return o;
    }
    Outcome twinwake(const std::vector<std::string>& arguments, rlim_t largest_file = 0,
                     const char* standard_output = nullptr) const {
        return finish(start(arguments, largest_file, standard_output));
    }

    std::set<std::string> files() const {
        std::set<std::string> names;
        for (const auto& entry : fs::recursive_directory_iterator(folder_))
            names.insert(fs::relative(entry.path(), folder_).string());
        return names;
    }

    fs::path folder_;
    fs::path stands_in_;  ///< folder in it where commands are given
};

inline const std::string planing = R"(title = "planing"
[hull]
shape = "prismatic"
trim  = "5 deg"
draft = "0.2 m"
half  = true
[motion]
kind  = "stream"
speed = "8 m/s"
[resolution]
near_hull = "0.1 m"
[run]
duration = "0.02 s"
)";

inline std::string with(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    if (at == std::string::npos) throw std::logic_error("the test's scene has no " + from);
    return text.replace(at, from.size(), to);
}

/// A small column of water that falls in a tank: about 1000 particles. `title` as it stands between quotes in a scene;
/// `run`: further lines of [run]; `probe`: where its pressure is taken.
inline std::string falling_column(const std::string& title, const std::string& run, const std::string& probe) {
    return "title = \"" + title + R"("
[tank]
size = [0.4, 0.2, 0.4]
[[water_block]]
min = [0, 0, 0]
max = [0.2, 0.2, 0.2]
[resolution]
near_hull = 0.02
[run]
)" + run + R"(
threads = 1
methods = ["sph"]
[[probe]]
pressure = )" +
           probe + "\n";
}

}  // namespace tw::test

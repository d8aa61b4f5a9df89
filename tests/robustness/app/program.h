#pragma once
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

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
        folder_ = fs::temp_directory_path() / "twinwake_command_tests" / (std::string(info->test_suite_name()) + "." + info->name());
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    void TearDown() override {
        if (!HasFailure()) fs::remove_all(folder_);
    }

    fs::path write(const std::string& name, const std::string& text) const {
        fs::create_directories((folder_ / name).parent_path());
        std::ofstream(folder_ / name, std::ios::binary) << text;
        return folder_ / name;
    }

    /// Runs the program in the test's folder, without a shell.
    Outcome twinwake(std::vector<std::string> arguments) const {
        const fs::path out = fs::temp_directory_path() / ("twinwake_out_" + std::to_string(getpid()));
        const fs::path err = fs::temp_directory_path() / ("twinwake_err_" + std::to_string(getpid()));
        const pid_t child = fork();
        if (child == 0) {
            if (chdir(folder_.c_str()) != 0) _exit(126);
            dup2(open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
            dup2(open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
            std::vector<char*> argv{const_cast<char*>(TWINWAKE_PROGRAM)};
            for (std::string& a : arguments) argv.push_back(a.data());
            argv.push_back(nullptr);
            execv(TWINWAKE_PROGRAM, argv.data());
            _exit(127);
        }
        int status = 0;
        waitpid(child, &status, 0);
        Outcome o{WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), content(out), content(err)};
        fs::remove(out);
        fs::remove(err);
        return o;
    }

    std::set<std::string> files() const {
        std::set<std::string> names;
        for (const auto& entry : fs::recursive_directory_iterator(folder_)) names.insert(fs::relative(entry.path(), folder_).string());
        return names;
    }

    fs::path folder_;
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

}  // namespace tw::test

// Child processes: no shell, an honest end, and none that outlives its parent.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "foam_cases/run/child.h"

namespace tw {
namespace child_test {
namespace fs = std::filesystem;

class ChildTest : public testing::Test {
protected:
    fs::path folder = fs::temp_directory_path() / ("foam child $(x) " + std::to_string(::getpid()));
    std::vector<std::string> environment{"PATH=/usr/bin:/bin", "GREETING=hello"};
    void SetUp() override { fs::create_directories(folder); }
    void TearDown() override { fs::remove_all(folder); }
    Ended run(const std::string& program, const std::vector<std::string>& arguments) {
        return ChildProcess({program, arguments}, environment, folder, folder / "log").wait();
    }
};

TEST_F(ChildTest, ArgumentsMeanThemselves) {
    EXPECT_TRUE(run("/bin/echo", {"$(touch x)", "; touch y", "a b", "\"q'"}).ok());
    EXPECT_EQ(read_text(folder / "log"), "$(touch x) ; touch y a b \"q'\n");
    EXPECT_FALSE(fs::exists(folder / "x"));
    EXPECT_FALSE(fs::exists(folder / "y"));
}

TEST_F(ChildTest, TheLogGrowsAndTheEnvironmentIsTheGivenOne) {
    run("/bin/sh", {"-c", "echo $GREETING; pwd >/dev/null"});
    run("/bin/sh", {"-c", "echo err >&2"});
    EXPECT_EQ(read_text(folder / "log"), "hello\nerr\n");
}

TEST_F(ChildTest, EndsAreReportedAsTheyWere) {
    EXPECT_EQ(run("/bin/sh", {"-c", "exit 3"}).status, 3);
    const Ended killed = run("/bin/sh", {"-c", "kill -FPE $$"});
    EXPECT_EQ(killed.signal, SIGFPE);
    EXPECT_FALSE(killed.ok());
    EXPECT_EQ(run("/bin/sh", {"-c", "exit 136"}).signal, SIGFPE) << "as mpirun and shells hand a signal on";
    const Ended worked = run("/bin/sh", {"-c", "i=0; while [ $i -lt 20000 ]; do i=$((i+1)); done"});
    EXPECT_GT(worked.cpu, 0);
    EXPECT_GT(worked.peak_memory, 1e5);
}

TEST_F(ChildTest, AProgramThatCannotBeStartedIsAnErrorWithItsName) {
    try {
        run("/no/such/program", {});
        FAIL();
    } catch (const RunError& e) { EXPECT_NE(std::string(e.what()).find("/no/such/program"), std::string::npos); }
    std::ofstream(folder / "text") << "no program";
    EXPECT_THROW(run(folder / "text", {}), RunError);
}

bool alive(pid_t pid) {
    std::ifstream stat("/proc/" + std::to_string(pid) + "/stat");
    std::string text;
    std::getline(stat, text);
    const std::size_t at = text.rfind(')');
    return at != std::string::npos && text[at + 2] != 'Z';
}

TEST_F(ChildTest, GoesWhenItsHandleGoes) {
    pid_t pid = -1;
    {
        ChildProcess child({"/bin/sleep", {"60"}}, environment, folder, folder / "log");
        pid = child.pid();
        EXPECT_FALSE(child.poll());
        EXPECT_TRUE(alive(pid));
    }
    EXPECT_FALSE(alive(pid));
}

TEST_F(ChildTest, GoesWhenItsParentIsKilled) {
    int report[2];
    ASSERT_EQ(::pipe(report), 0);
    const pid_t parent = ::fork();
    if (parent == 0) {
        ChildProcess child({"/bin/sleep", {"60"}}, environment, folder, folder / "log");
        const pid_t pid = child.pid();
        if (::write(report[1], &pid, sizeof pid) > 0) ::pause();
        ::_exit(1);
    }
    pid_t pid = -1;
    ASSERT_EQ(::read(report[0], &pid, sizeof pid), static_cast<ssize_t>(sizeof pid));
    EXPECT_TRUE(alive(pid));
    ::kill(parent, SIGKILL);
    ::waitpid(parent, nullptr, 0);
    for (int i = 0; i < 100 && alive(pid); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_FALSE(alive(pid));
}

}  // namespace child_test
}  // namespace tw

#include <pty.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "program.h"
#include "record/run_record.h"

namespace tw::test {
namespace watch_test {

using nlohmann::json;

/// A column of water that falls against a post: something has a force.
const std::string post = R"(title = "a column falls against a post"
[tank]
size = [0.4, 0.02, 0.3]
[domain]
dimensions = 2
[[water_block]]
min = [0, 0, 0]
max = [0.15, 0.02, 0.2]
[[obstacle]]
name = "post"
shape = "box"
length = 0.06
height = 0.1
position = [0.27, 0.01, 0]
[resolution]
near_hull = 0.02
[run]
duration = 0.3
threads = 1
methods = ["sph"]
[sampling]
mean_from = 0.1
)";

json facts(const fs::path& file) { return json::parse(content(file)); }

/// What the program prints on a terminal of so many columns.
std::string on_terminal(const fs::path& folder, unsigned short columns, std::vector<std::string> arguments) {
    winsize size{.ws_row = 24, .ws_col = columns, .ws_xpixel = 0, .ws_ypixel = 0};
    int master = -1;
    const pid_t child = forkpty(&master, nullptr, nullptr, &size);
    if (child == 0) {
        if (chdir(folder.c_str()) != 0) _exit(126);
        setenv("TERM", "xterm", 1);
        std::vector<char*> argv{const_cast<char*>(TWINWAKE_PROGRAM)};
        for (std::string& a : arguments) argv.push_back(a.data());
        argv.push_back(nullptr);
        execv(TWINWAKE_PROGRAM, argv.data());
        _exit(127);
    }
    std::string said;
    char buffer[4096];
    for (ssize_t n = 0; (n = read(master, buffer, sizeof buffer)) > 0;)
        said.append(buffer, static_cast<std::size_t>(n));
    close(master);
    waitpid(child, nullptr, 0);
    return said;
}

TEST_F(Command, ARunLeavesItsForcesAndMeansAndChecks) {
    write("post.toml", post);
    ASSERT_EQ(twinwake({"run", "post.toml", "--no-twins"}).status, 0);
    const RunRecord record = read_record(folder_ / "runs/post/sph/record.h5");
    const Table& forces = record.tables.at("forces");
    const std::vector<double>& fx = forces.find("fx")->values;
    double impulse = 0, late = 0, late_time = 0, last = 0;
    for (std::size_t k = 0; k < fx.size(); ++k) {
        const double t = forces.time[k], from = std::max(0.1, last);
        impulse += fx[k] * (t - last);
        if (t > from) late += fx[k] * (t - from), late_time += t - from;
        last = t;
    }
    ASSERT_GT(std::abs(impulse), 0);

    const json told = facts(folder_ / "runs/post/sph/progress.json");
    EXPECT_EQ(told["state"], "done");
    EXPECT_EQ(told["forces"][0]["name"], "fx");
    EXPECT_NEAR(told["forces"][0]["mean"].get<double>(), late / late_time, 1e-9 * std::abs(late / late_time));
    EXPECT_EQ(told["checks"].size(), record.validity_checks.size());

    // what the file's rows add up to is the impulse of all steps
    std::istringstream rows(content(folder_ / "runs/post/sph/forces.csv"));
    std::string line;
    std::getline(rows, line);
    EXPECT_EQ(line, "time [s],fx [N/m],fy [N/m],fz [N/m],my [N m/m]");
    double of_rows = 0, before = 0;
    while (std::getline(rows, line)) {
        double t = 0, mean = 0;
        ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf", &t, &mean), 2) << line;
        of_rows += mean * (t - before), before = t;
    }
    EXPECT_NEAR(before, last, 0.002);
    EXPECT_NEAR(of_rows, impulse, 1e-3 * std::abs(impulse));

    const Outcome status = twinwake({"status", "runs/post"});
    EXPECT_EQ(status.status, 0) << status.err;
    EXPECT_NE(status.out.find("1 of 1 runs are done"), std::string::npos) << status.out;
    EXPECT_NE(status.out.find("fx"), std::string::npos) << status.out;
    EXPECT_EQ(twinwake({"status", "runs/post/sph"}).out.find("no run in it"), std::string::npos);
}

TEST_F(Command, StatusKnowsTheRunsThatHaveNotBegunAndTheOneThatWasKilled) {
    write("post.toml",
          with(with(post, "duration = 0.3", "duration = 300\ncheckpoint = 0.05"), "0.02\n[run]", "0.01\n[run]"));
    const Started run = start({"run", "post.toml"});
    json status;
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(120);
    do {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        if (twinwake({"status", "runs/post", "-q", "--json", "status.json"}).status == 0)
            status = facts(folder_ / "status.json");
    } while (std::chrono::steady_clock::now() < end &&
             !(status.is_object() && status["runs"][0]["time"].get<double>() > 0));
    ASSERT_TRUE(status.is_object());
    EXPECT_FALSE(status["over"]);
    ASSERT_EQ(status["runs"].size(), 3u);
    EXPECT_EQ(status["runs"][0]["state"], "running");
    EXPECT_EQ(status["runs"][2]["state"], "waiting");
    EXPECT_GT(status["left"].get<double>(), status["runs"][0]["left"].get<double>());
    EXPECT_GT(status["runs"][0]["checks"].size(), 2u);

    kill(run.child, SIGKILL);
    finish(run);
    const Outcome watched = twinwake({"watch", "runs/post", "--every", "0.1"});  // ends by itself
    EXPECT_EQ(watched.status, 3);
    EXPECT_NE(watched.out.find("ended without a message"), std::string::npos) << watched.out;
    EXPECT_EQ(watched.out.find('\033'), std::string::npos);
    EXPECT_EQ(twinwake({"status", "."}).status, 0);  // finds them below, too
    fs::create_directory(folder_ / "empty");
    const Outcome nothing = twinwake({"status", "empty"});
    EXPECT_EQ(nothing.status, 2);
    EXPECT_NE(nothing.err.find("no run in it reports its progress"), std::string::npos) << nothing.err;
}

TEST_F(Command, ALineOfProgressIsNoWiderThanItsTerminal) {
    write("post.toml", post);
    for (const unsigned short columns : {60, 120}) {
        const std::string said = on_terminal(folder_, columns, {"run", "post.toml", "--no-twins", "--overwrite"});
        std::size_t drawn = 0, from = 0;
        for (std::size_t at = said.find("\r\033[K"); at != std::string::npos; at = said.find("\r\033[K", from)) {
            from = at + 4;
            const std::size_t line = said.find_first_of("\r\n", from) - from;
            EXPECT_LT(line, columns) << said.substr(from, line);
            ++drawn;
        }
        EXPECT_GT(drawn, 0u) << said;
        const std::string watched = on_terminal(folder_, columns, {"watch", "runs/post"});
        std::istringstream lines(watched);
        for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), columns) << line;  // with its \r
        EXPECT_NE(watched.find("1 of 1 runs are done"), std::string::npos) << watched;
    }
}

/// Until the file says it, or two minutes have passed.
bool says_in_time(const fs::path& file, const std::string& what) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(120);
    while (std::chrono::steady_clock::now() < end) {
        if (fs::exists(file) && content(file).find(what) != std::string::npos) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    return false;
}

TEST_F(Command, ARunningRunIsReportedAgainAndAgainAsProvisional) {
    write("post.toml", with(post, "duration = 0.3", "duration = 300\ncheckpoint = 0.05"));
    {
        const Started run = start({"run", "post.toml", "--no-twins", "--report-every", "1s"});
        ASSERT_TRUE(says_in_time(folder_ / "runs/post/report.html", "Provisional, as of 20"))
            << content(folder_ / "runs/post/report_so_far.log");
        const std::string page = content(folder_ / "runs/post/report.html");
        EXPECT_NE(page.find("1 run is not finished (SPH)"), std::string::npos);
        EXPECT_NE(page.find("</html>"), std::string::npos);
        kill(run.child, SIGINT);
        finish(run);
    }
    const json report = facts(folder_ / "runs/post/report.json");
    EXPECT_NE(report["sources"][0]["state"], "finished");
    // the page of a finished run is not
    write("post.toml", post);
    const Outcome whole = twinwake({"run", "post.toml", "--no-twins", "--overwrite", "--report-every", "1s"});
    EXPECT_EQ(whole.status, 0) << whole.err;
    EXPECT_EQ(content(folder_ / "runs/post/report.html").find("Provisional"), std::string::npos);
    for (const std::vector<std::string>& wrong :
         {std::vector<std::string>{"0 s"}, {"soon"}, {"10min", "--ranks", "2"}, {"10min", "--collect"}}) {
        std::vector<std::string> words{"run", "post.toml", "--overwrite", "--no-twins", "--report-every"};
        words.insert(words.end(), wrong.begin(), wrong.end());
        const Outcome refused = twinwake(words);
        EXPECT_EQ(refused.status, 2) << wrong.front();
        EXPECT_NE(refused.err.find("--report-every"), std::string::npos) << refused.err;
    }
}

}  // namespace watch_test
}  // namespace tw::test

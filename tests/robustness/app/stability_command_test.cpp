#include <nlohmann/json.hpp>

#include "program.h"

namespace tw::test {
namespace stability_command_test {

class StabilityCommand : public Command {};

TEST_F(StabilityCommand, WrongArgumentsAreRefusedBeforeTheWorkAndLeaveNothing) {
    EXPECT_EQ(twinwake({"stability", "--help"}).status, 0);
    for (const std::vector<std::string>& bad :
         {std::vector<std::string>{"--threads", "0"}, {"--threads", "many"}, {"--quik"}, {"scene.toml"}, {"--out"}}) {
        std::vector<std::string> all{"stability"};
        all.insert(all.end(), bad.begin(), bad.end());
        const Outcome o = twinwake(all);
        EXPECT_EQ(o.status, 2) << bad.front() << o.err;
        EXPECT_EQ(o.out, "");
    }
    const Outcome misspelt = twinwake({"stabilty"});
    EXPECT_NE(misspelt.err.find("did you mean 'stability'?"), std::string::npos) << misspelt.err;
    EXPECT_TRUE(files().empty());
}

TEST_F(StabilityCommand, AFolderThatCannotBeIsRefusedBeforeTheWork) {
    write("a_file", "x");
    const Outcome o = twinwake({"stability", "--quick", "--out", "a_file/map"});
    EXPECT_EQ(o.status, 2);
    EXPECT_EQ(o.err.substr(0, 49), "--out a_file/map: no folder can be made there: No");
    EXPECT_EQ(files(), std::set<std::string>{"a_file"});
}

TEST_F(StabilityCommand, StoppedItSaysSoAndWritesNothing) {
    const Started s = start({"stability", "--quick", "--threads", "1", "--out", "map"});
    for (int k = 0; k < 2400 && !fs::exists(folder_ / "map"); ++k) usleep(50000);
    kill(s.child, SIGINT);
    const Outcome o = finish(s);
    EXPECT_EQ(o.status, 3) << o.err;
    EXPECT_NE(o.err.find("stopped on request"), std::string::npos) << o.err;
    std::set<std::string> left = files();
    left.erase("map/.lock");  // the folder's lock, which stays as that of every folder
    EXPECT_EQ(left, std::set<std::string>{"map"});
}

}  // namespace stability_command_test
}  // namespace tw::test

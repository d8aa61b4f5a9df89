#include "program.h"

namespace tw::test {
namespace {

const char* const columns = "time [s],x [m],y [m],z [m],u [m/s],v [m/s],w [m/s],diameter [m]\n";
const std::string study = "[source]\ntable = \"drops.csv\"\n[flight]\nduration = \"1 s\"\n",
                  sensor = "[sensor]\ncentre = [2, 0, 0.8]\nnormal = [-1, 0, 0]\nextent = \"0.1 m\"\n"
                           "time_window = \"3 ms\"\n";

TEST_F(Command, SprayThatIsWrongIsRefusedAndNothingIsWritten) {
    write("drops.csv", std::string(columns) + "0,0,0,1,10,0,2,0.001\n");
    write("negative.csv", std::string(columns) + "0,0,0,1,10,0,2,-0.001\n");
    const struct {
        std::string text, complaint;
    } wrong[] = {
        {"[source]\ntable = \"absent.csv\"\n", "absent.csv: cannot be read"},
        {"[source]\ntable = \"negative.csv\"\n[flight]\nduration = 1\n", "negative.csv:2: a diameter of -0.001 m"},
        {study + "[flihgt]\n", "flihgt"},
        {study + "[target]\nname = \"x\"\n", "expected sections [[target]]"},
        {study + "[air]\nheights = [0, 0.1]\nalong_x = [1, 2]\n", "expected a field that covers the flight"},
        {study + sensor + "window = \"0.2 m\"\n", "is wider than the sensor's extent"},
    };
    for (const auto& [text, complaint] : wrong) {
        write("study.toml", text);
        const Outcome o = twinwake({"spray", "study.toml", "--out", "spray"});
        EXPECT_EQ(o.status, 2) << text;
        EXPECT_NE(o.err.find(complaint), std::string::npos) << o.err;
        EXPECT_FALSE(fs::exists(folder_ / "spray")) << text;
    }
}

TEST_F(Command, SprayThatReachesNothingHasNoLoadAndSaysSo) {
    write("drops.csv", std::string(columns) + "0,0,0,1,10,0,2,0.001\n");
    write("study.toml", study + "[[target]]\nname = \"far\"\ncentre = [100, 0, 50]\nnormal = [1, 0, 0]\nradius = 1\n");
    const Outcome o = twinwake({"spray", "study.toml", "--out", "spray"});
    EXPECT_EQ(o.status, 0) << o.err;
    EXPECT_NE(o.out.find("No droplet reaches this surface: its load is zero."), std::string::npos) << o.out;
    EXPECT_TRUE(fs::exists(folder_ / "spray" / "report.html"));
}

}  // namespace
}  // namespace tw::test

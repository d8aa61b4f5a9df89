#include "program.h"
#include "tests/unit/spray/row_of_cells.h"

namespace tw::test {
namespace spray_command_test {

const char* const columns = "time [s],x [m],y [m],z [m],u [m/s],v [m/s],w [m/s],diameter [m]\n";
const std::string study = "[source]\ntable = \"drops.csv\"\n[flight]\nduration = \"1 s\"\n",
                  sensor =
                      "[sensor]\ncentre = [2, 0, 0.8]\nnormal = [-1, 0, 0]\nextent = \"0.1 m\"\n"
                      "time_window = \"3 ms\"\n";

TEST_F(Command, SprayThatIsWrongIsRefusedAndNothingIsWritten) {
    write("drops.csv", std::string(columns) + "0,0,0,1,10,0,2,0.001\n");
    write("negative.csv", std::string(columns) + "0,0,0,1,10,0,2,-0.001\n");
    spray::write_row_of_cells(folder_ / "case");  // 3 x 1 x 1 m, U at 1 s only
    const std::string in_case = "[source]\ntable = \"drops.csv\"\n[flight]\nduration = 1\n[air]\nopenfoam = ";
    const struct {
        std::string text, complaint;
    } wrong[] = {
        {in_case + "\"case\"\n", "expected a field that covers the flight"},
        {in_case + "\"case\"\ntime = 0.5\n", "no time 0.5 s is written; it has 2 from 0 to 1 s"},
        {in_case + "\"case\"\ntime = 0\n", "field U is not there at 0 s"},
        {in_case + "\"absent\"\n", "no OpenFOAM case there"},
        {in_case + "\"case\"\nheights = [0, 1]\nalong_x = [1, 1]\n", "not both"},
        {study + "[air]\ntime = 1\n", "expected the case that has this time"},
        {"[source]\ntaken = \"absent\"\n", "expected RUN/sph of a run with a spray gate"},
        {"[source]\ntaken = \"a\"\nsph = \"b\"\n", "expected exactly one of sph, taken, fvm and table"},
        {"[source]\ntable = \"absent.csv\"\n", "absent.csv: cannot be read"},
        {"[source]\ntable = \"negative.csv\"\n[flight]\nduration = 1\n", "negative.csv:2: a diameter of -0.001 m"},
        {study + "[flihgt]\n", "flihgt"},
        {study + "[target]\nname = \"x\"\n", "expected sections [[target]]"},
        {study + "[air]\nheights = [0, 0.1]\nalong_x = [1, 2]\n", "expected a field that covers the flight"},
        {study + sensor + "window = \"0.2 m\"\n", "is wider than the sensor's extent"},
        {study + sensor + "face = 0\n", "face = 0"},
        {study + sensor + "measured = [10280]\n", "expected two repeats or more"},
        {study + sensor + "measured = [10280, -1]\n", "expected pressures above 0"},
        {study + "[extraction]\nalready_beyond = true\n", "expected a gate"},
    };
    for (const auto& [text, complaint] : wrong) {
        write("study.toml", text);
        const Outcome o = twinwake({"spray", "study.toml", "--out", "spray"});
        EXPECT_EQ(o.status, 2) << text;
        EXPECT_NE(o.err.find(complaint), std::string::npos) << o.err;
        EXPECT_FALSE(fs::exists(folder_ / "spray")) << text;
    }
}

/// A folder that holds something is left alone, and what the study has found is there all the same.
TEST_F(Command, SprayIsNotWrittenAsACloudOverOtherFiles) {
    write("drops.csv", std::string(columns) + "0,0,0,1,10,0,2,0.001\n");
    write("study.toml", study);
    write("cloud/mine", "text");
    const Outcome o = twinwake({"spray", "study.toml", "--out", "spray", "--openfoam-cloud", "cloud"});
    EXPECT_EQ(o.status, 2);
    EXPECT_NE(o.err.find("cloud: exists already and is not empty"), std::string::npos) << o.err;
    EXPECT_EQ(content(folder_ / "cloud/mine"), "text");
    EXPECT_FALSE(fs::exists(folder_ / "cloud/system"));
    EXPECT_TRUE(fs::exists(folder_ / "spray/report.html"));
}

/// Text of a study or a table never becomes OpenFOAM's: a cloud is made of numbers.
TEST_F(Command, SprayAsACloudHoldsNumbersOnly) {
    write("drops.csv", std::string(columns) + "0,0,0,1,10,0,2,0.001\n");
    write("study.toml", "title = \"#calc \\\"system(\\\\\\\"touch own\\\\\\\")\\\"; $x\"\n" + study);
    const Outcome o = twinwake({"spray", "study.toml", "--out", "spray", "--openfoam-cloud", "cloud"});
    EXPECT_EQ(o.status, 0) << o.err;
    for (const auto& file : fs::recursive_directory_iterator(folder_ / "cloud/constant")) {
        if (!file.is_regular_file()) continue;
        EXPECT_EQ(content(file.path()).find_first_of("#$"), std::string::npos) << file.path();
        EXPECT_EQ(content(file.path()).find("calc"), std::string::npos) << file.path();
    }
    EXPECT_FALSE(fs::exists(folder_ / "cloud/own"));
}

TEST_F(Command, SprayIsComparedWithAnotherOne) {
    write("drops.csv", std::string(columns) + "0,0,0,1,10,0,2,0.001\n");
    write("study.toml", study);
    ASSERT_EQ(twinwake({"spray", "study.toml", "--out", "first"}).status, 0);
    const Outcome o = twinwake({"spray", "study.toml", "--out", "second", "--against", "first"});
    EXPECT_EQ(o.status, 0) << o.err;
    EXPECT_NE(o.out.find("mean speed, by volume"), std::string::npos) << o.out;
    EXPECT_NE(content(folder_ / "second/two_sprays.csv").find("first"), std::string::npos);
    const Outcome absent = twinwake({"spray", "study.toml", "--out", "third", "--against", "nowhere"});
    EXPECT_EQ(absent.status, 2);
    EXPECT_NE(absent.err.find("nowhere/droplets.csv: cannot be read"), std::string::npos) << absent.err;
    EXPECT_FALSE(fs::exists(folder_ / "third"));
}

TEST_F(Command, SprayThatReachesNothingHasNoLoadAndSaysSo) {
    write("drops.csv", std::string(columns) + "0,0,0,1,10,0,2,0.001\n");
    write("study.toml", study + "[[target]]\nname = \"far\"\ncentre = [100, 0, 50]\nnormal = [1, 0, 0]\nradius = 1\n");
    const Outcome o = twinwake({"spray", "study.toml", "--out", "spray"});
    EXPECT_EQ(o.status, 0) << o.err;
    EXPECT_NE(o.out.find("No droplet reaches this surface: its load is zero."), std::string::npos) << o.out;
    EXPECT_TRUE(fs::exists(folder_ / "spray" / "report.html"));
}

}  // namespace spray_command_test
}  // namespace tw::test

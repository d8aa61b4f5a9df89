// Pressure probes as a user meets them.
#include <cmath>
#include <nlohmann/json.hpp>

#include "program.h"

namespace tw::test {
namespace probes_test {

// A column falls and strikes the wall beside it after about 0.2 s: for some tens of milliseconds P1 feels it.
/// Beside a solid that stands, here out of the water's reach, neighbours are found at nearly every step of such a fall.
/// Else a frame, at which they are found as well, changes last digits and with them the splash: the peak by 8 %.
std::string struck_wall(const std::string& interval) {
    return falling_column("struck wall", "duration = 0.4", "[0.4, 0.1, 0.02]") +
           "[[obstacle]]\nmin = [0, 0, 0.36]\nmax = [0.1, 0.2, 0.4]\n[sampling]\ninterval = " + interval + "\n";
}

TEST_F(Command, AParticleRunsPressurePeakIsTheSameWhateverItsFramesAre) {
    std::vector<nlohmann::json> peaks;
    for (const std::string interval : {"0.005", "0.05"}) {
        write("wall.toml", struck_wall(interval));
        const Outcome o = twinwake({"run", "wall.toml", "--no-twins", "--out", interval, "--json", "facts.json"});
        ASSERT_EQ(o.status, 0) << o.err;
        const auto facts = nlohmann::json::parse(content(folder_ / "facts.json"));
        for (const auto& q : facts["quantities"])
            if (q["name"] == "pressure_peak:P1") peaks.push_back(q);
    }
    ASSERT_EQ(peaks.size(), 2u);
    EXPECT_EQ(peaks[0]["label"], "Peak pressure at P1, mean over 5 ms");
    EXPECT_EQ(peaks[1]["label"], peaks[0]["label"]);
    const double often = peaks[0]["values"][0], seldom = peaks[1]["values"][0];
    EXPECT_GT(often, 10e3) << "the wall is struck";  // rho g 0.2 m is 2 kPa
    EXPECT_NEAR(seldom / often, 1, 1e-4);  // steps shorter than half a millisecond: a frame is one more sample
}

}  // namespace probes_test
}  // namespace tw::test

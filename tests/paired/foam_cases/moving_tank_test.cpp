// A tank that moves, by interFoam, against what holds for any method; the same laws hold for the particles in
// tests/verification/sph_solver/moving_tank_test.cpp.
#include <cmath>
#include <numbers>

#include "foam_test.h"

namespace tw {
namespace moving_tank_test {

constexpr double g = 9.81;

class MovingTanks : public FoamTest {
protected:
    /// Water of depth 0.3 m in a tank of 1 m; probes 25 mm from both walls and near the floor.
    RunRecord run(const std::string& motion, double duration) {
        const Scene s = scene("[tank]\nmin = [-0.5, 0, -0.3]\nmax = [0.5, 0.05, 0.3]\n" + motion +
                              "[domain]\ndimensions = 2\n[motion]\nkind = \"none\"\n[resolution]\nnear_hull = 0.025\n"
                              "[[probe]]\nname = \"left\"\nheight = [-0.475, 0]\n[[probe]]\nname = \"right\"\n"
                              "height = [0.475, 0]\n[[probe]]\nname = \"floor\"\npressure = [0.1, 0, -0.25]\n"
                              "[[probe]]\nname = \"on_floor\"\npressure = [0.1, 0, -0.3]\n"
                              "[[probe]]\nname = \"corner\"\npressure = [0.5, 0, -0.3]\n"
                              "[sampling]\ninterval = 0.02\n[run]\nduration = " +
                              std::to_string(duration) + "\n");
        return run_fvm(s, options());
    }
    static double mean_after(const Table& t, const char* name, double from) {
        const auto first = std::lower_bound(t.time.begin(), t.time.end(), from) - t.time.begin();
        return mean(*t.find(name), static_cast<std::size_t>(first));
    }
};

TEST_F(MovingTanks, ThatHeaveMakeTheirWaterHeavierAndLighter) {
    const RunRecord r =
        run("law = \"sinusoid\"\nalong = [0, 0, 1]\namplitude = 0.05\nperiod = 1\nphase = \"90 deg\"\n", 1);
    const Table& t = r.tables.at("pressure");
    const std::vector<double>& p = t.find("floor")->values;
    const double w = 2 * std::numbers::pi, swing = 1000 * 0.25 * 0.05 * w * w;
    for (std::size_t i = 0; i < t.time.size(); ++i) {
        if (t.time[i] < 0.05) continue;
        const double felt = g - 0.05 * w * w * std::cos(w * t.time[i]);
        EXPECT_NEAR(p[i], 1000 * 0.25 * felt, 0.05 * swing) << t.time[i];
        // Half a cell of 25 mm would be 4 %.
        for (const char* wall : {"on_floor", "corner"})
            EXPECT_NEAR(t.find(wall)->values[i], 1000 * 0.3 * felt, 0.003 * 1000 * 0.3 * g) << wall << " " << t.time[i];
    }
}

/// About a place beside the tank, so that each of the frame's forces but Coriolis' takes part.
TEST_F(MovingTanks, ThatHeelSlowlyKeepTheirSurfaceLevel) {
    const double angle = 5 * std::numbers::pi / 180;
    const RunRecord r =
        run("law = \"table\"\nabout = [0, 1, 0]\npivot = [0.8, 0, -0.5]\ntimes = [0, 3]\nvalues = [0, " +
                std::to_string(angle) + "]\n",
            4.2);  // a swing of the water takes 1.32 s
    const Table& t = r.tables.at("height");
    const double slope = (mean_after(t, "right", 2.87) - mean_after(t, "left", 2.87)) / 0.95;
    EXPECT_NEAR(slope, std::tan(angle), 0.05 * std::tan(angle));
}

}  // namespace moving_tank_test
}  // namespace tw

// Cavity and crown of a body that enters water, on frames whose cavity and crown are known.
#include "compare/metrics/entry.h"
#include "base/numbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "meshes/generate.h"
#include "record/raster.h"

namespace tw {
namespace entry_test {

constexpr double edge = 0.05, step = 0.01;  // of the voxels [m], between frames [s]

/// A ball of 0.4 m that goes down at 10 m/s from the surface; `wet(x, time)` says where water is besides the place of
/// the body, within `hole` [m] of the ball's centre, over 0.3 s.
RunRecord ball_in(const std::function<bool(const Vec3&, double)>& wet, double hole = 0.2) {
    RunRecord r;
    r.attributes = {{"method", "sph"}, {"motion", "none"}, {"scene_hash", "s"}, {"hull_hash", ""}};
    r.numbers = {{"duration", 0.3}, {"gravity", 9.81}, {"density", 1000}};
    r.state = "finished";
    constexpr std::size_t nx = 20, nz = 88;
    r.raster = {{-0.5, -0.5, -3.2}, edge, {nx, nx, nz}};
    Surface ball = make_hull("sphere", {{"diameter", 0.4}});
    const Box box = ball.bounds();
    for (Vec3& p : ball.points) p += Vec3(0, 0, 0.2) - (box.min + box.max) / 2;
    r.bodies.push_back({"body_ball", ball, {0, 0, 0.2}});
    Table& t = r.table("body_ball");
    for (int f = 1; f <= 30; ++f) {
        const double time = step * f;
        const Vec3 centre(0, 0, 0.2 - 10 * time);
        t.time.push_back(time);
        const auto put = [&](const char* name, const char* unit, double value) {
            t.column(name, unit).values.push_back(value);
        };
        put("x", "m", 0), put("y", "m", 0), put("z", "m", centre.z());
        put("q0", "-", 1), put("qx", "-", 0), put("qy", "-", 0), put("qz", "-", 0);
        RasterFrame frame{time, std::vector<std::uint8_t>(nx * nx * nz)};
        for (std::size_t k = 0, n = 0; k < nz; ++k)
            for (std::size_t j = 0; j < nx; ++j)
                for (std::size_t i = 0; i < nx; ++i, ++n) {
                    const Vec3 x = r.raster.origin + edge * Vec3(double(i) + 0.5, double(j) + 0.5, double(k) + 0.5);
                    if ((x - centre).norm() > hole && wet(x, time)) frame.water[n] = 255;
                }
        r.frames.push_back(std::move(frame));
    }
    return r;
}

double radius(const Vec3& x) { return std::hypot(x.x(), x.y()); }

double value(const Comparison& c, const std::string& name) {
    const Quantity* q = c.find(name);
    return q ? q->values.front().value : NAN;
}

/// A shaft of 0.6 m behind the ball; from 0.2 s on it is closed from 1 to 1.2 m below the surface.
bool deep_seal(const Vec3& x, double time) {
    const double bottom = 0.2 - 10 * time;  // centre of the ball
    const bool pinched = time > 0.2 - 1e-9 && x.z() < -1 && x.z() > -1.2;
    return x.z() < 0 && (pinched || radius(x) > 0.3 || x.z() < bottom);
}

TEST(Entry, FindsADeepSealWhereAndWhenTheShaftIsPinchedOff) {
    const Comparison c = compare_records({ball_in(deep_seal)});
    EXPECT_NEAR(value(c, "cavity_seal:ball"), 0.195, step / 2 + 1e-9);
    EXPECT_NEAR(value(c, "cavity_seal_depth:ball"), 1.2, edge);
    EXPECT_NEAR(value(c, "cavity_closure:ball"), 0.195, step / 2 + 1e-9) << "the upper part has left the ball";
    EXPECT_NEAR(value(c, "cavity_depth:ball"), 10 * 0.19 - 0.2, 2 * edge) << "to the ball's middle";
    const Table& entry = c.analyses[0].entries[0];
    const double shaft = pi * 0.3 * 0.3;  // volume per metre
    EXPECT_NEAR(entry.find("open_volume")->values[14] / (shaft * (1.5 - 0.2 - 0.2)), 1, 0.1)
        << "less the voxels round the ball";
    EXPECT_NEAR(entry.find("closed_volume")->values[24] / (shaft * (2.5 - 0.2 - 0.2 - 1.2)), 1, 0.1);
}

TEST(Entry, FindsASurfaceSealUnderADome) {
    // the same shaft, never pinched, under a dome of water 0.3 m above the surface from 0.1 s on
    const auto dome = [](const Vec3& x, double time) {
        const double out = x.norm();
        if (x.z() >= 0) return time > 0.1 - 1e-9 && out > 0.3 && out < 0.45;
        return radius(x) > 0.3 || x.z() < 0.2 - 10 * time;
    };
    const Comparison c = compare_records({ball_in(dome)});
    EXPECT_NEAR(value(c, "cavity_seal:ball"), 0.095, step / 2 + 1e-9);
    EXPECT_NEAR(value(c, "cavity_seal_depth:ball"), -0.3, edge);
    EXPECT_NEAR(value(c, "crown_height:ball"), 0.45, edge);
    EXPECT_NEAR(value(c, "crown_volume:ball") / (2 * pi / 3 * (0.45 * 0.45 * 0.45 - 0.3 * 0.3 * 0.3)), 1, 0.15)
        << "half a shell, less a voxel above still water";
}

TEST(Entry, ACavityThatFillsFromBelowClosesWithoutAPocket) {
    // its bottom comes up again from 0.1 s on at 8 m/s: 1 m deep then, gone after 0.225 s
    const auto filling = [](const Vec3& x, double time) {
        const double bottom = time < 0.1 ? 0.2 - 10 * time : -0.8 + 8 * (time - 0.1);
        return x.z() < 0 && (radius(x) > 0.3 || x.z() < bottom);
    };
    RunRecord r = ball_in(filling, 0);
    // a long rod instead of the ball keeps the cavity at a body's side
    Surface rod = make_hull("cylinder", {{"diameter", 0.2}, {"span", 6.0}});
    const Box box = rod.bounds();
    for (Vec3& p : rod.points) {
        const Vec3 q = p - (box.min + box.max) / 2;
        p = Vec3(q.x(), q.z(), q.y()) + Vec3(0, 0, 3);
    }
    for (auto& t : rod.triangles) std::swap(t[0], t[1]);
    r.bodies[0].surface = rod;
    const Comparison c = compare_records({r});
    EXPECT_FALSE(c.find("cavity_seal:ball")->values[0].known);
    EXPECT_NEAR(value(c, "cavity_closure:ball"), 0.2 - edge / 8, step) << "a voxel below the surface";
}

TEST(Entry, WaterThatClimbsOneSideIsAnAsymmetry) {
    const auto climbing = [](const Vec3& x, double time) {
        const double line = x.x() < 0 ? -0.4 : -0.9;  // beside the rod, from 0.15 s on
        return x.z() < 0 && (radius(x) > 0.3 || x.z() < (time < 0.15 ? 0.2 - 10 * time : line));
    };
    RunRecord r = ball_in(climbing, 0);
    Surface rod = make_hull("box", {{"length", 0.2}, {"beam", 0.2}, {"height", 6.0}});
    const Box box = rod.bounds();
    for (Vec3& p : rod.points) p += Vec3(0, 0, 3) - (box.min + box.max) / 2;
    r.bodies[0].surface = rod;
    const Comparison c = compare_records({r});
    EXPECT_NEAR(value(c, "cavity_asymmetry:ball"), 0.5, edge + 1e-9) << "higher at smaller x";
    const Table& entry = c.analyses[0].entries[0];
    EXPECT_GT(entry.find("cavity_high_x")->values[20], 1.5 * entry.find("cavity_low_x")->values[20]);
}

TEST(Entry, AGapNarrowerThanAVoxelAndADimpleAreNoCavity) {
    const auto tight = [](const Vec3& x, double time) {
        return x.z() < 0 && (x - Vec3(0, 0, 0.2 - 10 * time)).norm() > 0.2 + 0.5 * edge;
    };
    const Comparison c = compare_records({ball_in(tight)});
    EXPECT_EQ(c.find("cavity_closure:ball"), nullptr);
    EXPECT_EQ(c.find("crown_height:ball"), nullptr);
    EXPECT_EQ(c.analyses[0].entries[0].find("open_volume")->values[25], 0);
}

TEST(Entry, ACavityThatIsOpenAtTheEndHasNoClosure) {
    const auto open = [](const Vec3& x, double time) {
        return x.z() < 0 && (radius(x) > 0.3 || x.z() < 0.2 - 10 * time);
    };
    const Comparison c = compare_records({ball_in(open)});
    ASSERT_NE(c.find("cavity_closure:ball"), nullptr);
    EXPECT_FALSE(c.find("cavity_closure:ball")->values[0].known);
    EXPECT_FALSE(c.find("cavity_closure:ball")->values[0].why_not.empty());
    EXPECT_NEAR(value(c, "cavity_depth:ball"), 2.8, 2 * edge);
}

}  // namespace entry_test
}  // namespace tw

// Sizes of particles in a scene: where their zones lie, and what a run is predicted to take.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "meshes/query.h"
#include "scene/hash.h"
#include "scene/particles/cost_of_sizes.h"
#include "scene/particles/particle_levels.h"
#include "scene/particles/particles_of_sizes.h"
#include "scene/refined_places.h"
#include "scene/water/water_blocks.h"
#include "scene_text.h"

namespace tw::test {
namespace levels_test {

std::string with_levels(int levels) { return planing + "\n[sph]\nlevels = " + std::to_string(levels) + "\nzone = 8\n"; }

TEST(ParticleLevels, ZonesHoldTheHullLieOnTheCoarseLatticeAndKeepTheirDistances) {
    const Scene scene = scene_of(with_levels(3) + "[domain]\nahead = \"4 m\"\nbelow = \"2.6 m\"\n");
    const std::vector<Zone> zones = particle_zones(scene);
    ASSERT_EQ(zones.size(), 2u);
    const Box &wide = zones[0].boxes()[0], &narrow = zones[1].boxes()[0], hull = scene.hull->surface.bounds();
    const double dp = 0.05;
    EXPECT_LE(narrow.min.z(), hull.min.z() - 8 * dp);
    EXPECT_GE(narrow.max.y(), hull.max.y() + 8 * dp);
    EXPECT_LE(wide.min.z(), narrow.min.z() - 10 * 2 * dp);
    EXPECT_LE(wide.min.x(), narrow.min.x() - 8 * 2 * dp);
    EXPECT_EQ(narrow.min.y(), -INFINITY);  // the plane of symmetry
    EXPECT_EQ(narrow.max.z(), INFINITY);   // the sky
    EXPECT_GE(wide.min.x(), scene.domain.box.min.x() + 8 * 4 * dp);
    EXPECT_NEAR(std::remainder(narrow.min.z(), 2 * dp), 0, 1e-12);
    for (int a = 0; a < 3; ++a) EXPECT_NEAR(std::remainder(scene.domain.box.min[a], 4 * dp), 0, 1e-12);
}

// Of its box a zone is what is nearer to the hull than its width, and what stands above that.
TEST(ParticleLevels, ZonesFollowTheHull) {
    const Scene scene = scene_of(with_levels(2) + "[domain]\nahead = \"4 m\"\nside = \"4 m\"\nbelow = \"4 m\"\n");
    const std::vector<Zone> zones = particle_zones(scene);
    const Zone& zone = zones[0];
    ASSERT_TRUE(zone.follows_surface());
    const double width = 8 * 0.05;
    EXPECT_DOUBLE_EQ(zone.width(), width);
    const SurfaceQuery hull(scene.hull->surface);
    const Box& box = zone.boxes()[0];
    int near = 0, far = 0;
    for (double x = box.min.x() + 0.01; x < box.max.x(); x += 0.17)
        for (double y = 0; y < box.max.y(); y += 0.11)
            for (double z = box.min.z() + 0.01; z < -0.2; z += 0.11) {
                const double distance = hull.nearest({x, y, z}).distance;
                if (std::abs(distance - width) < 0.05) continue;  // half of the grid's spacing
                distance < width ? ++near : ++far;
                EXPECT_EQ(zone.outside({x, y, z}) < 0, distance < width) << x << " " << y << " " << z;
            }
    EXPECT_GT(near, 100);
    EXPECT_GT(far, 100);
    const Box bounds = scene.hull->surface.bounds();
    const Vec3 beside(bounds.max.x() - 0.5, bounds.max.y() + width / 2, 0);
    ASSERT_LT(zone.outside(beside), 0);
    EXPECT_LT(zone.outside(beside + Vec3(0, 0, 1.5)), 0);  // spray above it
}

const std::string far_box = "\n[[refine]]\nname = \"crest\"\nmin = [3.6, 1, -0.5]\nmax = [4.2, 1.4, 0.2]\n",
                  wide_domain = "[domain]\nahead = \"4 m\"\nbehind = \"8 m\"\nside = \"5 m\"\n";

// One description, both methods: the cells of the box are as fine as its particles.
TEST(ParticleLevels, ABoxOfTheSceneIsAZoneOfItsOwnAndFinerCells) {
    const Scene scene = scene_of(with_levels(3) + wide_domain + far_box + "spacing = 0.15\n");
    const std::vector<Zone> zones = particle_zones(scene);
    ASSERT_EQ(zones[0].boxes().size(), 2u);
    EXPECT_EQ(zones[1].boxes().size(), 1u);  // particles of 0.1 m are fine enough there
    const Box& crest = zones[0].boxes()[1];
    EXPECT_LE(crest.min.y(), 1);
    EXPECT_GE(crest.max.y(), 1.4);
    EXPECT_EQ(crest.max.z(), INFINITY);
    const auto box = std::ranges::find(scene.refinement, "crest", &RefinementBox::name);
    ASSERT_NE(box, scene.refinement.end());
    EXPECT_DOUBLE_EQ(scene.resolution.spacing / std::exp2(box->level), 0.1);
    const std::vector<ParticlesOfSize> with_box = particles_of_sizes(scene),
                                       without = particles_of_sizes(scene_of(with_levels(3) + wide_domain));
    EXPECT_GT(with_box[1].active, without[1].active + 0.6 * 0.4 * 0.5 / 0.001);
    EXPECT_EQ(with_box[2].all(), without[2].all());
}

// Where the hull has dipped and pitched to, a zone is again what is near to it.
TEST(ParticleLevels, ZonesGoWithAHullThatIsFree) {
    const std::string free = "half     = true\nfree = [\"heave\", \"pitch\"]\nmass = 300\nlcg = 1.6\nvcg = 0.3\n";
    const Scene scene = scene_of(with(with_levels(3), "half     = true\n", free) +
                                 "[domain]\nahead = \"4 m\"\nside = \"4 m\"\nbelow = \"4 m\"\n");
    ASSERT_TRUE(zones_move(scene));
    std::vector<MovedSolid> moving = moving_at_start(scene);
    ASSERT_EQ(moving.size(), 1u);
    const std::vector<Zone> start = particle_zones(scene);
    Surface moved = scene.hull->surface;
    const Vec3 about(2.4, 0, 0.1), dip(0, 0, -0.3);
    moving[0].way =
        Eigen::Translation3d(about + dip) * Eigen::AngleAxisd(0.07, Vec3::UnitY()) * Eigen::Translation3d(-about);
    for (Vec3& x : moved.points) x = moving[0].way * x;
    moving[0].bounds = moved.bounds();
    const std::vector<Zone> zones = particle_zones(scene, moving, start);
    ASSERT_EQ(zones.size(), 2u);
    const SurfaceQuery hull(moved);
    for (const Zone& zone : zones) {
        ASSERT_TRUE(zone.follows_surface());
        const double width = zone.width(), coarse = &zone == &zones[0] ? 0.2 : 0.1;
        int near = 0, far = 0, elsewhere = 0;
        for (double x = 0; x < 4.4; x += 0.13)
            for (double y = 0; y < 2; y += 0.11)
                for (double z = -2; z < -0.5; z += 0.11) {
                    const double distance = hull.nearest({x, y, z}).distance;
                    if (std::abs(distance - width) < coarse / 2) continue;
                    distance < width ? ++near : ++far;
                    EXPECT_EQ(zone.outside({x, y, z}) < 0, distance < width) << x << " " << y << " " << z;
                    elsewhere += (start[coarse == 0.2 ? 0 : 1].outside({x, y, z}) < 0) != (distance < width);
                }
        EXPECT_GT(near, 50);
        EXPECT_GT(far, 100);
        EXPECT_GT(elsewhere, 50) << "or zones that stand would do";
    }
}

TEST(ParticleLevels, BoxesWithoutRoomForCoarseParticlesBetweenBecomeOne) {
    const Scene scene =
        scene_of(with_levels(2) + wide_domain + "\n[[refine]]\nmin = [2.7, 0, -0.5]\nmax = [4.2, 0.5, 0.2]\n");
    const Zone zone = particle_zones(scene)[0];
    ASSERT_EQ(zone.boxes().size(), 1u);
    EXPECT_GE(zone.boxes()[0].max.x(), 4.2);
}

TEST(ParticleLevels, ManyBoxesAreOneOrFarApart) {
    std::string text = with_levels(2) + "[domain]\nahead = \"60 m\"\nbehind = \"60 m\"\nside = \"60 m\"\n";
    for (int i = 0; i < 120; ++i) {
        const double x = 15 + 0.45 * (i * 37 % 47), y = 0.45 * (i * 29 % 53);
        text += fmt::format("[[refine]]\nmin = [{}, {}, -0.5]\nmax = [{}, {}, 0.2]\n", x, y, x + 0.2, y + 0.2);
    }
    const Zone zone = particle_zones(scene_of(text))[0];
    const std::vector<Box>& boxes = zone.boxes();
    EXPECT_GT(boxes.size(), 1u);
    EXPECT_LT(boxes.size(), 121u);
    for (const Box& a : boxes)
        for (const Box& b : boxes) {
            const double apart = (b.min - a.max).cwiseMax(a.min - b.max).maxCoeff();
            EXPECT_TRUE(apart <= 0 || apart >= 8 * 0.1 - 1e-9) << apart;
        }
}

TEST(ParticleLevels, BoxesAreRefusedWhereTheyCanDoNothing) {
    const auto complaint_of = [](const std::string& box) { return complaint(planing + "\n[[refine]]\n" + box); };
    EXPECT_NE(complaint_of("min = [50, 0, 0]\nmax = [51, 1, 1]\n").find("outside the domain"), std::string::npos);
    EXPECT_NE(complaint_of("min = [2, 0, 0]\nmax = [1, 1, 1]\n").find("has no volume"), std::string::npos);
    EXPECT_NE(
        complaint_of("min = [2, 0, 0]\nmax = [3, 1, 1]\nspacing = 0.0032\n").find("16 times finer than near_hull"),
        std::string::npos);
    EXPECT_NE(complaint_of("around = \"wake\"\nmin = [2, 0, 0]\n").find("does not belong to around = \"wake\""),
              std::string::npos);
    EXPECT_NE(complaint_of("around = \"spray_root\"\nlength = 2\n").find("does not belong"), std::string::npos);
}

// Wagner's root of the jet on a wedge that enters water: pi/2 as far out as where still water meets it.
TEST(ParticleLevels, TheSprayRootIsFinerThanTheHull) {
    const Scene scene =
        scene_of(planing + one_size + "\n[[refine]]\nname = \"root\"\naround = \"spray_root\"\nspacing = 0.025\n" +
                 "width = 0.15\n");
    EXPECT_EQ(scene.sph.levels, 1);
    EXPECT_EQ(finest_spacing(scene), 0.025);
    const std::vector<Zone> zones = particle_zones(scene);
    ASSERT_EQ(zones.size(), 1u);
    const double trim = std::numbers::pi / 36, deadrise = std::numbers::pi / 9,
                 stern = scene.hull->still.wet_bounds.max.x();
    for (double ahead = 1.3; ahead < 2.2; ahead += 0.1) {
        const double deep = 0.2 - ahead * std::tan(trim), y = std::numbers::pi / 2 * deep / std::tan(deadrise),
                     z = (std::numbers::pi / 2 - 1) * deep;
        EXPECT_LT(zones[0].outside({stern - ahead, y, z}), -0.1) << ahead;
    }
    EXPECT_GT(zones[0].outside({stern - 0.2, 0.1, -0.3}), 0.1);  // under the stern the hull's own size is enough
    int boxes = 0;
    for (const RefinementBox& r : scene.refinement)
        if (r.name.starts_with("root")) {
            ++boxes;
            EXPECT_DOUBLE_EQ(scene.resolution.spacing / std::exp2(r.level), 0.025);
        }
    EXPECT_GT(boxes, 4);
    EXPECT_EQ(particles_of_sizes(scene).back().spacing, 0.025);
}

TEST(ParticleLevels, WakeAndFreeSurfaceArePlacesWithNames) {
    const auto zone_of = [](const std::string& place) {
        return particle_zones(scene_of(with_levels(2) + wide_domain + "\n[[refine]]\n" + place)).front();
    };
    const Vec3 behind(8, 0.2, -0.1), beside(1, 3, -0.1);
    EXPECT_GT(zone_of("min = [2, 0, -0.1]\nmax = [2.1, 0.1, 0.1]\n").outside(behind), 0);
    const Zone wake = zone_of("around = \"wake\"\nwidth = 0.3\nlength = 6\n"),
               surface = zone_of("around = \"free_surface\"\nwidth = 0.3\n");
    EXPECT_LT(wake.outside(behind), 0);
    EXPECT_GT(wake.outside(beside), 0);
    EXPECT_LT(surface.outside(behind), 0);
    EXPECT_LT(surface.outside(beside), 0);
    EXPECT_GT(surface.outside({1, 3, -1}), 0);
}

// Cells of four times near_hull follow the wake to the outlet; without a zone of its own it would end where particles
// of the hull's zones do.
TEST(ParticleLevels, TheWakeOfAHullHasParticlesOfTwiceItsSize) {
    const auto size_at = [](const Scene& scene, const Vec3& x) {
        double size = std::ldexp(finest_spacing(scene), sizes_of_particles(scene) - 1);
        for (const Zone& zone : particle_zones(scene))
            if (zone.outside(x) < 0) size /= 2;
        return size;
    };
    const Vec3 behind(8, 0.3, -0.1), beside(8, 3, -0.1), deep(8, 0.3, -1.6);
    const Scene scene = scene_of(planing + wide_domain);
    ASSERT_EQ(scene.sph.levels, 3);
    EXPECT_EQ(scene.sph.wake, 2);
    EXPECT_DOUBLE_EQ(size_at(scene, behind), 0.1);
    EXPECT_DOUBLE_EQ(size_at(scene, beside), 0.2);
    EXPECT_DOUBLE_EQ(size_at(scene, deep), 0.2);
    EXPECT_DOUBLE_EQ(size_at(scene_of(planing + wide_domain + "[sph]\nwake = 0\n"), behind), 0.2);
    EXPECT_DOUBLE_EQ(size_at(scene_of(planing + wide_domain + "[sph]\nwake = 1\n"), behind), 0.05);
    EXPECT_DOUBLE_EQ(size_at(scene_of(planing + wide_domain + "[sph]\nlevels = 3\n"), behind), 0.2);
    EXPECT_EQ(scene_of(planing + one_size).sph.wake, 0);
}

// What a user calls the size far away, or what is taken for it where a hull is held in a fast stream, holds for the
// particles as for the cells, as far as there is room for them.
TEST(ParticleLevels, TheSpacingIsThatOfBothMethods) {
    const auto levels_of = [](const std::string& resolution, const std::string& rest) {
        std::string text = planing;
        const std::string size = R"(near_hull = "0.05 m")";
        const std::size_t at = text.find(size);
        return scene_of(text.replace(at, size.size(), resolution) + rest).sph.levels;
    };
    const std::string coarse = "near_hull = 0.05\nspacing = 0.2";
    EXPECT_EQ(levels_of("near_hull = 0.05", wide_domain), 3);
    EXPECT_EQ(scene_of(with(planing, "8 m/s", "4 m/s") + wide_domain).sph.levels, 1);  // it does not plane
    const std::string sunk = "[hull]\nshape = \"torpedo\"\ndraft = \"2 m\"\n[motion]\nspeed = \"8 m/s\"\n";
    EXPECT_EQ(scene_of(sunk).sph.levels, 1);
    EXPECT_EQ(levels_of(coarse, wide_domain), 3);
    EXPECT_EQ(levels_of(coarse, wide_domain + "[sph]\nlevels = 2\n"), 2);
    EXPECT_EQ(levels_of(coarse, "[domain]\nahead = \"1.5 m\"\n"), 2);  // those of 0.2 m find no room ahead
    EXPECT_EQ(levels_of(coarse, wide_domain + "[sph]\nscheme = \"symplectic_euler\"\n"), 1);
}

// The coarser runs that tell the discretisation error are of one family: the same box, and room in it for their zones.
TEST(ParticleLevels, TwinsHaveTheSameBoxAndCostLess) {
    SceneOverrides twice;
    twice.scale_resolution = 2;
    const Scene fine = scene_of(planing), twin = scene_of(planing, twice);
    EXPECT_EQ(twin.domain.as_asked.min, fine.domain.as_asked.min);
    EXPECT_EQ(twin.domain.as_asked.max, fine.domain.as_asked.max);
    EXPECT_EQ(twin.sph.levels, fine.sph.levels);
    EXPECT_LT(predict(twin).of("sph").seconds, 0.2 * predict(fine).of("sph").seconds);
}

// So that they differ in nothing but the size: as many sizes, edges at the same places, an eighth of the particles.
TEST(ParticleLevels, OfCoarserRunsHaveTheirEdgesAtTheSamePlaces) {
    const std::string text = planing + wide_domain + "below = \"3 m\"\n[sph]\nlevels = 3\n";
    const Scene fine = scene_of(text);
    const std::vector<Zone> zones = particle_zones(fine);
    ASSERT_EQ(zones.size(), 2u);
    for (const double scale : {std::numbers::sqrt2 / 2, std::numbers::sqrt2, 2.0}) {
        SceneOverrides coarser;
        coarser.scale_resolution = scale;
        const Scene coarse = scene_of(text, coarser);
        ASSERT_EQ(coarse.sph.levels, 3) << scale;
        const std::vector<Zone> twins = particle_zones(coarse);
        for (std::size_t k = 0; k < 2; ++k) {
            EXPECT_NEAR(twins[k].width(), zones[k].width(), 1e-9) << scale;
            const Box &mine = zones[k].boxes()[0], &its = twins[k].boxes()[0];
            const double lattice =
                std::ldexp(std::max(fine.resolution.near_hull, coarse.resolution.near_hull), k == 0 ? 2 : 1) * 1.001;
            for (int a = 0; a < 3; ++a)
                for (const auto& [x, y] : {std::pair{mine.min[a], its.min[a]}, std::pair{mine.max[a], its.max[a]}})
                    if (std::isinf(x))
                        EXPECT_EQ(y, x) << scale << ", zone " << k << ", axis " << a;
                    else
                        EXPECT_NEAR(y, x, lattice) << scale << ", zone " << k << ", axis " << a;
        }
        EXPECT_LT(predict(coarse).particles, 1.5 / std::pow(scale, 3) * predict(fine).particles) << scale;
    }
    // in spacings neither below eight, within which the hull and the buffers of the edge would meet, nor ever more
    SceneOverrides coarsest, finest;
    coarsest.scale_resolution = 4, finest.scale_resolution = 0.25;
    EXPECT_DOUBLE_EQ(zone_width(scene_of(text, coarsest)), 8 * 0.2);
    EXPECT_DOUBLE_EQ(zone_width(scene_of(text, finest)), std::numbers::sqrt2 * 16 * 0.0125);
}

TEST(ParticleLevels, TakeFewerParticlesAndLessTimeThanOneSize) {
    const std::string box = "[domain]\nside = \"2 m\"\nbelow = \"1.6 m\"\n";
    const Scene fine = scene_of(planing + box), both = scene_of(with_levels(2) + box);
    const Prediction one = predict(fine), two = predict(both);
    EXPECT_LT(two.particles, 0.6 * one.particles);
    EXPECT_LT(two.of("sph").seconds, 0.7 * one.of("sph").seconds);
}

// Every place in the water has one owner, and what stands under a zone of half the spacing is an eighth of what it
// stands for.
TEST(ParticleLevels, ThePredictionAddsUpOverTheSizes) {
    const Scene scene = scene_of(with_levels(3) + wide_domain);
    const Prediction p = predict(scene);
    const std::vector<CostOfSize> sizes = cost_of_sizes(scene, p, p.of("sph"));
    ASSERT_EQ(sizes.size(), 3u);
    double water = 0, particles = 0, seconds = 0, bytes = 0;
    for (const CostOfSize& s : sizes) {
        water += s.particles.active * std::pow(s.particles.spacing, 3);
        particles += s.particles.all();
        seconds += s.seconds;
        bytes += s.bytes;
    }
    EXPECT_NEAR(water, water_volume(scene), 1e-9 * water);
    EXPECT_NEAR(particles, p.particles, 1e-9 * particles);
    EXPECT_NEAR(seconds, p.of("sph").seconds, 1e-9 * seconds);
    EXPECT_NEAR(bytes, p.of("sph").bytes - p.raster_bytes, 1e-9 * bytes);
    EXPECT_EQ(sizes[0].particles.guards, 0);
    EXPECT_EQ(sizes[2].particles.parents, 0);
    EXPECT_NEAR(8 * sizes[1].particles.parents, sizes[2].particles.active, 1e-9 * sizes[2].particles.active);
    EXPECT_DOUBLE_EQ(sizes[0].dt, 4 * sizes[2].dt);
    EXPECT_GT(sizes[1].particles.guards, 0);
}

TEST(ParticleLevels, OneSizeLeavesTheHashesOfEarlierRecordsAlone) {
    const std::string slow = with(planing, "8 m/s", "4 m/s");
    EXPECT_EQ(scene_of(slow + one_size).hash, scene_of(slow).hash);
    EXPECT_EQ(run_hash(scene_of(slow + one_size), "sph"), run_hash(scene_of(slow), "sph"));
    const Scene plain = scene_of(planing + one_size), said = scene_of(with_levels(1));
    EXPECT_NE(run_hash(said, "sph"), run_hash(plain, "sph"));  // another zone was asked for
    const Scene two = scene_of(with_levels(2));
    EXPECT_NE(run_hash(two, "sph"), run_hash(said, "sph"));
    const Scene wide_two = scene_of(with_levels(2) + wide_domain), wide_three = scene_of(with_levels(3) + wide_domain);
    EXPECT_EQ(family_hash(wide_two, "sph"), family_hash(wide_three, "sph"));  // their sizes alone differ
}

TEST(ParticleLevels, AreRefusedWhereTheyHaveNoRoomOrNoSolid) {
    const auto refused = [](const std::string& text) {
        try {
            particle_zones(scene_of(text));
        } catch (const InputError& e) { return std::string(e.what()); }
        return std::string();
    };
    EXPECT_NE(refused(with_levels(5)).find("do not fit between the inlet and the hull"), std::string::npos);
    const auto pool = [](const std::string& rest) {
        return "[tank]\nsize = [4, 2, 1.6]\n[[water_block]]\nmin = [0, 0, 0]\nmax = [2, 2, 1.2]\n[motion]\nkind = "
               "\"none\"\n[resolution]\nnear_hull = 0.05\n[run]\nduration = 1\n" +
               rest;
    };
    EXPECT_NE(refused(pool("[sph]\nlevels = 2\n")).find("stand round a hull, an obstacle or a body"),
              std::string::npos);
    const std::string post = "[[obstacle]]\nmin = [3, 0.9, 0]\nmax = [3.2, 1.1, 1]\n[sph]\nzone = 8\nlevels = ";
    EXPECT_EQ(refused(pool(post + "2\n")), "");
    EXPECT_NE(refused(pool(post + "4\n")).find("have no room in this tank"), std::string::npos);
}

const std::string falling =
    "[tank]\nmin = [-3, -3, -3]\nmax = [3, 3, 1]\n[[body]]\nname = \"ball\"\nshape = \"cylinder\"\n"
    "diameter = 0.4\nspan = 0.4\ndraft = 0\ndensity = 1500\nvelocity = [0, 0, -3]\n[motion]\nkind = \"none\"\n"
    "[run]\nduration = 0.2\n[sph]\nzone = 8\n";

// A body takes its zones along; they reach the sky, and a wall that leaves no room for coarser particles.
TEST(ParticleLevels, GoWithABodyThroughATank) {
    const Scene scene = scene_of(falling + "[resolution]\nnear_hull = 0.05\nspacing = 0.1\n");
    ASSERT_EQ(scene.sph.levels, 2);
    const Box start = particle_zones(scene)[0].boxes()[0], body = scene.bodies[0].surface.bounds();
    EXPECT_NEAR(start.min.z(), body.min.z() - 8 * 0.05, 1e-9);
    EXPECT_NEAR(start.max.x(), body.max.x() + 8 * 0.05, 1e-9);
    EXPECT_EQ(start.max.z(), INFINITY);
    const Vec3 way(0.3, 0, -1.1);
    const auto with_it = [&](const Vec3& by) {
        return particle_zones(scene, std::vector<MovedSolid>{{{body.min + by, body.max + by}}}, {})[0].boxes()[0];
    };
    const Box later = with_it(way);
    EXPECT_NEAR(later.min.x(), start.min.x() + 0.3, 1e-9);
    EXPECT_NEAR(later.min.z(), start.min.z() - 1.1, 1e-9);
    const Vec3 deep(0, 0, -2);
    EXPECT_EQ(with_it(deep).min.z(), -INFINITY);
}

// To 2 % of its length, as particles of one size do without being asked.
TEST(ParticleLevels, OfATankFillItsWater) {
    const auto levels_of = [](const std::string& text) { return scene_of(text).sph.levels; };
    const std::string sizes = "[resolution]\nnear_hull = 0.05\nspacing = 0.2\n";
    EXPECT_EQ(levels_of(falling + sizes), 3);
    std::string odd = falling;
    odd.replace(odd.find("[3, 3, 1]"), 9, "[3.1, 3, 1]");  // 30.5 particles of 0.2 m
    EXPECT_EQ(levels_of(odd + sizes), 3);
    odd = falling;
    odd.replace(odd.find("[-3, -3, -3]"), 12, "[-3, -3, -2.9]");  // 14.5 of them, 3.4 % too many
    EXPECT_EQ(levels_of(odd + sizes), 2);
    // Coarser and finer runs of one scene are similar: as many sizes, in cells that are stretched by up to 7 %.
    SceneOverrides larger, finer;
    larger.scale_resolution = std::sqrt(2), finer.scale_resolution = 0.5;
    EXPECT_EQ(scene_of(falling + sizes, finer).sph.levels, 3);
    EXPECT_EQ(scene_of(odd + sizes, finer).sph.levels, 2) << "though 0.1 m fill it better";
    std::string wide = falling;
    wide.replace(wide.find("[-3, -3, -3]"), 12, "[-6, -6, -3]"), wide.replace(wide.find("[3, 3, 1]"), 9, "[6, 6, 1]");
    EXPECT_EQ(levels_of(wide + sizes), 3);
    EXPECT_EQ(scene_of(wide + sizes, larger).sph.levels, 3) << "10.6 of 0.283 m, 3.7 % too few";
    EXPECT_EQ(scene_of(falling + sizes, larger).sph.levels, 2) << "0.283 m have no room beside the zone";
    EXPECT_EQ(levels_of(falling + "scheme = \"symplectic_euler\"\n" + sizes), 1);
}

}  // namespace levels_test
}  // namespace tw::test

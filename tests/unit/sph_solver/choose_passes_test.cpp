// Which variant of the passes a run uses, and that all of them make the same sums.
#include "sph_solver/choose_passes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <random>
#include <string>

#include "base/errors.h"
#include "sph_solver/neighbours/pencils.h"
#include "sph_solver/pair_loops/views.h"

namespace tw {
namespace choose_passes_test {

namespace fs = std::filesystem;

/// Environment variables set for one test, the cache folder among them.
class Environment {
public:
    explicit Environment(const std::string& cache) {
        set("XDG_CACHE_HOME", cache.c_str());
        set("TWINWAKE_ISA", nullptr);
    }
    ~Environment() {
        for (const auto& [name, before] : before_) put(name, before ? before->c_str() : nullptr);
    }
    void set(const char* name, const char* value) {
        const char* before = std::getenv(name);
        before_.insert(before_.begin(), {name, before ? std::optional<std::string>(before) : std::nullopt});
        put(name, value);
    }

private:
    static void put(const std::string& name, const char* value) {
        if (value)
            setenv(name.c_str(), value, 1);
        else
            unsetenv(name.c_str());
    }
    std::vector<std::pair<std::string, std::optional<std::string>>> before_;
};

TEST(ChoosePasses, TakesTheDefaultUnlessAnotherIsClearlyFaster) {
    Passes a{}, b{};
    EXPECT_EQ(&best_of({{&a, 2.0e6}, {&b, 2.08e6}}), &a);
    EXPECT_EQ(&best_of({{&a, 2.0e6}, {&b, 2.2e6}}), &b);
    EXPECT_EQ(&best_of({{&a, 2.0e6}, {&b, 1.0e6}}), &a);
}

TEST(ChoosePasses, MeasuresOnceAndRemembers) {
    const fs::path folder = fs::temp_directory_path() / "tw_choose_passes_test";
    fs::remove_all(folder);
    {
        Environment environment(folder.string());
        const Passes& chosen = choose_passes();
        const std::vector<const Passes*> candidates = passes_to_choose_from();
        EXPECT_NE(std::ranges::find(candidates, &chosen), candidates.end());
        EXPECT_EQ(fs::exists(folder / "twinwake/passes.json"), candidates.size() > 1);
        for (const Passes* p : candidates) {  // what is remembered counts, not what is measured
            remember_passes(*p);
            EXPECT_EQ(choose_passes().isa, p->isa);
        }
        std::ofstream(folder / "twinwake/passes.json") << "{ cut off";
        choose_passes();  // forgets, and measures anew
        environment.set("TWINWAKE_ISA", "baseline");
        EXPECT_STREQ(choose_passes().isa, "baseline");
        environment.set("TWINWAKE_ISA", "default");
        EXPECT_EQ(&choose_passes(), runnable_passes().front());
        environment.set("TWINWAKE_ISA", "abacus");
        EXPECT_THROW(choose_passes(), InputError);
    }
    fs::remove_all(folder);
}

TEST(ChoosePasses, WhereNothingCanBeRememberedTakesTheDefault) {
    Environment environment("/proc/nowhere");
    EXPECT_EQ(&choose_passes(), runnable_passes().front());
}

/// The first pair loop and the forces of a jittered block with one variant, in the order of its lattice.
struct Sums {
    std::vector<PackedRate> rate;
    std::vector<double> divergence, support;
};
Sums sums_with(const Passes& passes) {
    constexpr double dp = 0.1, h = 1.5 * dp;
    constexpr int edge = 10;
    const FixedPoint fixed_point(Vec3::Zero(), dp / (1 << 18));
    const PencilGrid grid({Vec3::Zero(), Vec3::Constant(edge * dp)}, dp, 3, fixed_point, passes.lanes);
    std::mt19937 random(9);
    std::uniform_real_distribution<double> jitter(-0.2 * dp, 0.2 * dp);
    std::uniform_real_distribution<float> any(-1, 1);
    std::vector<WidePlace> raw;
    std::vector<PackedVelocityDensity> all_motion;
    for (int k = 0; k < edge * edge * edge; ++k) {
        const Vec3 x = dp * Vec3(k % edge, k / edge % edge, k / edge / edge);
        raw.push_back(fixed_point.wide(x + Vec3(jitter(random), jitter(random), jitter(random))));
        all_motion.push_back({any(random), any(random), any(random), any(random)});
    }
    raw[1] = raw[0];  // two at one place
    std::vector<std::int32_t> order, start;
    sort_by_pencil(grid, raw, order, start);
    std::vector<PackedPlace> place;
    std::vector<PackedVelocityDensity> motion;
    for (const std::int32_t k : order) {
        place.push_back(raw[static_cast<std::size_t>(k)].packed(static_cast<float>(dp * dp * dp)));
        motion.push_back(all_motion[static_cast<std::size_t>(k)]);
    }
    std::vector<PackedGradientPressure> stress(place.size());
    std::vector<PackedShiftSupport> shift(place.size());
    std::vector<PackedRate> rate(place.size());
    const std::vector<std::uint32_t> surface(place.size() / 32 + 2, 0);
    std::vector<Cluster> clusters;
    NeighbourLists lists;
    const Source source{&grid, place.data(), &start, 0};
    make_clusters(source, passes.lanes, clusters);
    lists.build(passes, fixed_point, source, clusters, {source}, {2.6 * h, 2.3 * h, 1.4 * h});
    const WaterView water{.list = lists.view(),
                          .place = place.data(),
                          .motion = motion.data(),
                          .stress = stress.data(),
                          .surface = surface.data(),
                          .kernel = Kernel(h, 3),
                          .unit = static_cast<float>(fixed_point.size),
                          .inv_mass = static_cast<float>(1 / (1000 * dp * dp * dp))};
    FirstPairLoopData first{.water = water, .stress = stress.data(), .shift = shift.data(), .rate = rate.data()};
    first.inv_W_dp = static_cast<float>(1 / water.kernel.W(dp));
    SecondPairLoopData second{.water = water, .shift = shift.data(), .rate = rate.data()};
    second.diffusion = 2, second.viscosity = 100;
    PruneData prune;
    prune.lists = lists.view();
    prune.of = prune.place = place.data();
    prune.reach = 2 * h / fixed_point.size;
    const int count = static_cast<int>(clusters.size());
    passes.run(prune, clusters.data(), count);
    passes.run(first, clusters.data(), count);
    Sums sums;
    sums.rate.resize(place.size()), sums.divergence.resize(place.size()), sums.support.resize(place.size());
    for (std::size_t k = 0; k < place.size(); ++k) {
        const auto i = static_cast<std::size_t>(order[k]);
        sums.divergence[i] = rate[k].drho, sums.support[i] = shift[k].support;
        stress[k].p = 400 * motion[k].drho;
    }
    passes.run(second, clusters.data(), count);
    for (std::size_t k = 0; k < place.size(); ++k) sums.rate[static_cast<std::size_t>(order[k])] = rate[k];
    return sums;
}

TEST(Variants, AllMakeTheSameSumsToRounding) {
    const std::vector<const Passes*> all = runnable_passes();
    const Sums exact = sums_with(passes("baseline"));
    double largest_a = 0, largest_D = 0, largest_div = 0;
    for (std::size_t i = 0; i < exact.rate.size(); ++i) {
        largest_a = std::max(largest_a, std::abs(double(exact.rate[i].az)));
        largest_D = std::max(largest_D, std::abs(double(exact.rate[i].drho)));
        largest_div = std::max(largest_div, std::abs(exact.divergence[i]));
    }
    EXPECT_GT(std::min({largest_a, largest_D, largest_div}), 1);
    for (const Passes* p : all) {
        const Sums sums = sums_with(*p);
        double a = 0, D = 0, div = 0, support = 0;
        for (std::size_t i = 0; i < exact.rate.size(); ++i) {
            a = std::max(a, std::abs(double(sums.rate[i].az) - exact.rate[i].az));
            D = std::max(D, std::abs(double(sums.rate[i].drho) - exact.rate[i].drho));
            div = std::max(div, std::abs(sums.divergence[i] - exact.divergence[i]));
            support = std::max(support, std::abs(sums.support[i] - exact.support[i]));
        }
        std::printf("  %-16s %2d lanes: differs by %.1e of an acceleration, %.1e of D, %.1e of div u, %.1e of S\n",
                    p->isa, p->lanes, a / largest_a, D / largest_D, div / largest_div, support);
        EXPECT_LT(a, 3e-6 * largest_a) << p->isa;
        EXPECT_LT(D, 3e-6 * largest_D) << p->isa;
        EXPECT_LT(div, 3e-6 * largest_div) << p->isa;
        EXPECT_LT(support, 1e-5) << p->isa;
    }
}

}  // namespace choose_passes_test
}  // namespace tw

#include "sph_solver/choose_passes.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "base/atomic_file.h"
#include "base/cache_folder.h"
#include "base/errors.h"
#include "base/own_json.h"
#include "record/this_machine.h"
#include "sph_solver/domain/level_setup.h"
#include "sph_solver/equations/water_completeness.h"
#include "sph_solver/neighbours/list_life.h"
#include "sph_solver/neighbours/pencils.h"
#include "sph_solver/pair_loops/views.h"

namespace tw {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Jittered water on a floor of dummy particles, with a free surface: lists as a run makes them, of more particles than
/// the second cache holds.
class Block {
public:
    explicit Block(const Passes& passes) : passes_(passes) {
        const FixedPoint fixed_point(Vec3::Zero(), dp / (1 << 18));
        const PencilGrid grid({Vec3(0, 0, -floor * dp), Vec3::Constant(edge * dp)}, dp, 3, fixed_point, passes.lanes);
        std::mt19937 random(1);
        std::uniform_real_distribution<double> jitter(-0.1 * dp, 0.1 * dp);
        std::vector<WidePlace> water, dummies;
        for (int k = 0; k < edge * edge * edge; ++k)
            water.push_back(fixed_point.wide(cell(k, 0) + Vec3(jitter(random), jitter(random), jitter(random))));
        for (int k = 0; k < edge * edge * floor; ++k) dummies.push_back(fixed_point.wide(cell(k, -floor)));
        std::vector<std::int32_t> start, wall_start;
        sort(grid, water, place_, start);
        sort(grid, dummies, wall_place_, wall_start);
        const std::size_t n = place_.size();
        motion_.resize(n), stress_.resize(n), shift_.resize(n), rate_.resize(n), surface_.resize(n / 32 + 2);
        normal_.assign(n, {0, 0, 1, 0});
        wall_p_.resize(wall_place_.size());
        const auto top = static_cast<std::int32_t>((edge - 1) * dp / fixed_point.size);
        for (std::size_t i = 0; i < n; ++i)
            if (place_[i].z > top) surface_[i / 32] |= std::uint32_t{1} << (i % 32);
        const Kernel kernel(1.55 * dp, 3);
        const double support = kernel.support();
        const Source source{&grid, place_.data(), &start, 0}, walls{&grid, wall_place_.data(), &wall_start, 0};
        const auto within = [&](double slack) { return Reaches{support + slack, support, support - slack}; };
        make_clusters(source, passes.lanes, clusters_);
        lists_.build(passes, fixed_point, source, clusters_, {source}, within(ListLife::least_slack_over_dp * dp));
        wall_lists_.build(passes, fixed_point, source, clusters_, {walls}, within(ListLife::wall_slack_over_dp * dp),
                          &Cluster::wall_list);
        const auto end = static_cast<std::int32_t>(wall_place_.size());
        wall_load_.resize(static_cast<std::size_t>(number_wall_loads(clusters_, wall_lists_.view(), {end})));
        first_ = {.water = {.list = lists_.view(),
                            .place = place_.data(),
                            .motion = motion_.data(),
                            .stress = stress_.data(),
                            .surface = surface_.data(),
                            .kernel = kernel,
                            .unit = static_cast<float>(fixed_point.size)},
                  .walls = {.list = wall_lists_.view(),
                            .place = wall_place_.data(),
                            .p = wall_p_.data(),
                            .normal = normal_.data()},
                  .stress = stress_.data(),
                  .shift = shift_.data(),
                  .rate = rate_.data(),
                  .inv_W_dp = static_cast<float>(1 / kernel.W(dp)),
                  .inv_dp = static_cast<float>(1 / dp),
                  .surface_support = static_cast<float>(LevelSetup{}.surface_support),
                  .given_back = static_cast<float>(WaterCompleteness::of_plane_surface(kernel, dp, 3))};
        second_ = {.water = first_.water,
                   .walls = first_.walls,
                   .shift = shift_.data(),
                   .rate = rate_.data(),
                   .wall_load = wall_load_.data()};
        prune_ = {
            .lists = lists_.view(), .of = place_.data(), .place = place_.data(), .reach = support / fixed_point.size};
        prune_walls_ = {.lists = wall_lists_.view(),
                        .list = &Cluster::wall_list,
                        .of = place_.data(),
                        .place = wall_place_.data(),
                        .reach = support / fixed_point.size};
    }
    /// One evaluation of all particles [s].
    double time() {
        const auto start = std::chrono::steady_clock::now();
        const int count = static_cast<int>(clusters_.size());
        passes_.run(prune_, clusters_.data(), count);
        passes_.run(prune_walls_, clusters_.data(), count);
        passes_.run(first_, clusters_.data(), count);
        passes_.run(second_, clusters_.data(), count);
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
    double particles() const { return double(place_.size()); }

private:
    static constexpr double dp = 0.01;
    static constexpr int edge = 44, floor = 3;

    static Vec3 cell(int k, int lowest) {
        return dp * Vec3(k % edge + 0.5, k / edge % edge + 0.5, lowest + k / edge / edge + 0.5);
    }
    static void sort(const PencilGrid& grid, const std::vector<WidePlace>& raw, std::vector<PackedPlace>& places,
                     std::vector<std::int32_t>& start) {
        std::vector<std::int32_t> order;
        sort_by_pencil(grid, raw, order, start);
        for (const std::int32_t k : order)
            places.push_back(raw[static_cast<std::size_t>(k)].packed(static_cast<float>(dp * dp * dp)));
    }

    const Passes& passes_;
    std::vector<PackedPlace> place_, wall_place_;
    std::vector<PackedVelocityDensity> motion_;
    std::vector<PackedGradientPressure> stress_;
    std::vector<PackedShiftSupport> shift_;
    std::vector<PackedRate> rate_;
    std::vector<PackedWallNormal> normal_;
    std::vector<float> wall_p_;
    std::vector<WallLoad> wall_load_;
    std::vector<std::uint32_t> surface_;
    std::vector<Cluster> clusters_;
    NeighbourLists lists_, wall_lists_;
    FirstPairLoopData first_;
    SecondPairLoopData second_;
    PruneData prune_, prune_walls_;
};

fs::path memory_file() {
    const fs::path folder = cache_folder();
    return folder.empty() ? folder : folder / "passes.json";
}
Json read_memory() {
    Json memory = Json::object();
    try {
        if (fs::is_regular_file(memory_file()))
            read_own_json(memory_file(), [&](const Json& json) {
                if (json.is_object()) memory = json;
            });
    } catch (const InputError&) {}
    return memory;
}
/// A program with other variants measures anew.
std::string names_to_choose_from() {
    std::string names;
    for (const Passes* p : passes_to_choose_from()) names += std::string(names.empty() ? "" : " ") + p->isa;
    return names;
}

}  // namespace

std::vector<PassesPace> measure_passes(const std::vector<const Passes*>& which) {
    constexpr int rounds = 3;
    std::vector<Block> blocks;
    blocks.reserve(which.size());
    for (const Passes* p : which) blocks.emplace_back(*p);
    std::vector<double> least(which.size(), 1e30);
    for (int round = 0; round < rounds; ++round)
        for (std::size_t k = 0; k < which.size(); ++k) least[k] = std::min(least[k], blocks[k].time());
    std::vector<PassesPace> paces;
    for (std::size_t k = 0; k < which.size(); ++k) paces.push_back({which[k], blocks[k].particles() / least[k]});
    return paces;
}

const Passes& best_of(const std::vector<PassesPace>& paces) {
    const auto fastest = std::ranges::max_element(paces, {}, &PassesPace::evaluations_per_second);
    const bool clearly = fastest->evaluations_per_second > 1.05 * paces.front().evaluations_per_second;
    return clearly ? *fastest->passes : *paces.front().passes;
}

const Passes& choose_passes() {
    if (const Passes* asked = passes_asked_for()) return *asked;
    const std::vector<const Passes*> candidates = passes_to_choose_from();
    if (candidates.size() == 1 || memory_file().empty()) return *candidates.front();
    const auto remembered = [&]() -> const Passes* {
        try {
            const Json of_machine = read_memory().at(cpu_model());
            if (of_machine.at("among") != names_to_choose_from()) return nullptr;
            for (const Passes* p : runnable_passes())
                if (of_machine.at("isa") == p->isa) return p;
        } catch (const Json::exception&) {}
        return nullptr;
    };
    if (const Passes* p = remembered()) return *p;
    remember_passes(best_of(measure_passes(candidates)));
    if (const Passes* p = remembered()) return *p;
    return *candidates.front();
}

void remember_passes(const Passes& chosen) {
    if (memory_file().empty()) return;
    try {
        Json memory = read_memory();
        memory[cpu_model()] = {{"isa", chosen.isa}, {"among", names_to_choose_from()}};
        fs::create_directories(memory_file().parent_path());
        write_text_atomically(memory_file(), memory.dump(1) + "\n");
    } catch (const std::exception&) {}  // not remembered then
}

}  // namespace tw

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
#include "record/this_machine.h"
#include "sph_solver/neighbours/columns.h"
#include "sph_solver/sweeps/views.h"

namespace tw {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// A cube of jittered water with its lists; small enough for the second cache.
class Block {
public:
    explicit Block(const Passes& passes) : passes_(passes) {
        const Quanta quanta(Vec3::Zero(), dp / (1 << 18));
        const ColumnGrid grid({Vec3::Zero(), Vec3::Constant(edge * dp)}, dp, 3, quanta, passes.lanes);
        std::mt19937 random(1);
        std::uniform_real_distribution<double> jitter(-0.1 * dp, 0.1 * dp);
        std::vector<WidePlace> raw;
        for (int k = 0; k < edge * edge * edge; ++k)
            raw.push_back(quanta.wide(Vec3(k % edge * dp + jitter(random), k / edge % edge * dp + jitter(random),
                                           k / edge / edge * dp + jitter(random))));
        std::vector<std::int32_t> order, start;
        sort_by_column(grid, raw, order, start);
        for (const std::int32_t k : order)
            place_.push_back(raw[static_cast<std::size_t>(k)].record(static_cast<float>(dp * dp * dp)));
        const std::size_t n = place_.size();
        motion_.resize(n), stress_.resize(n), shift_.resize(n), rate_.resize(n), surface_.resize(n / 32 + 2);
        const Kernel kernel(1.5 * dp, 3);
        const double support = kernel.support(), skin = 0.3 * dp;
        const Source source{&grid, place_.data(), &start, 0};
        make_groups(source, passes.lanes, groups_);
        lists_.build(passes, quanta, source, groups_, {source}, {support + skin, support, support - skin});
        const WaterView water{.list = lists_.view(),
                              .place = place_.data(),
                              .motion = motion_.data(),
                              .stress = stress_.data(),
                              .surface = surface_.data(),
                              .kernel = kernel,
                              .quantum = static_cast<float>(quanta.size)};
        first_ = {.water = water, .stress = stress_.data(), .shift = shift_.data(), .rate = rate_.data()};
        first_.inv_W_dp = static_cast<float>(1 / kernel.W(dp));
        second_ = {.water = water, .shift = shift_.data(), .rate = rate_.data()};
        prune_.lists = lists_.view();
        prune_.of = prune_.place = place_.data();
        prune_.reach = support / quanta.size;
    }
    /// One evaluation of all particles [s].
    double time() {
        const auto start = std::chrono::steady_clock::now();
        const int count = static_cast<int>(groups_.size());
        passes_.run(prune_, groups_.data(), count);
        passes_.run(first_, groups_.data(), count);
        passes_.run(second_, groups_.data(), count);
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
    double particles() const { return double(place_.size()); }

private:
    static constexpr double dp = 0.01;
    static constexpr int edge = 16;

    const Passes& passes_;
    std::vector<PlaceRecord> place_;
    std::vector<VelocityDensityRecord> motion_;
    std::vector<GradientPressureRecord> stress_;
    std::vector<ShiftSupportRecord> shift_;
    std::vector<RateRecord> rate_;
    std::vector<std::uint32_t> surface_;
    std::vector<Group> groups_;
    NeighbourLists lists_;
    FirstSweepData first_;
    SecondSweepData second_;
    PruneData prune_;
};

fs::path memory_file() {
    const fs::path folder = cache_folder();
    return folder.empty() ? folder : folder / "passes.json";
}
Json read_memory() {
    try {
        if (fs::exists(memory_file()))
            if (Json memory = Json::parse(read_text(memory_file())); memory.is_object()) return memory;
    } catch (const std::exception&) {}
    return Json::object();
}
/// A program with other variants measures anew.
std::string names_to_choose_from() {
    std::string names;
    for (const Passes* p : passes_to_choose_from()) names += std::string(names.empty() ? "" : " ") + p->isa;
    return names;
}

}  // namespace

std::vector<PassesPace> measure_passes(const std::vector<const Passes*>& which) {
    constexpr int rounds = 6;
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

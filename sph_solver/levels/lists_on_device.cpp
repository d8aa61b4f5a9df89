#include "sph_solver/levels/lists_on_device.h"

#include <bit>

#include "sph_solver/cuda/launch.h"

namespace tw {

int RunningSum::add_up() {
    const int n = static_cast<int>(of_.size());
    before_.resize(of_.size() + 1);
    if (n == 0) {
        before_.set_zero();
        return 0;
    }
    const int blocks = (n + cuda::scanned_by_block - 1) / cuda::scanned_by_block;
    sums_.resize(static_cast<std::size_t>(blocks) + 1);
    const int* const of = of_.data();
    int *const sums = sums_.data(), *const before = before_.data();
    const std::size_t threads = static_cast<std::size_t>(blocks) * cuda::threads_in_block;
    cuda::launch_threads(device_, threads, cuda::ScanBlocks{of, sums, n});
    cuda::launch_threads(device_, cuda::threads_in_block, cuda::ScanSums{sums, blocks});
    cuda::launch_threads(device_, threads, cuda::ScanFill{of, sums, before, n});
    return before_.value(of_.size());
}

void RunningSum::download_before(std::vector<std::int32_t>& to, std::size_t stride) const {
    std::vector<int> all(before_.size());
    before_.download(all);
    to.clear();
    for (std::size_t k = 0; k < all.size(); k += stride) to.push_back(all[k]);
}

std::size_t SortedOnDevice::sort(const WidePlace* wide, const std::uint8_t* left, const std::int64_t* tie,
                                 std::size_t n) {
    bin_.resize(n), slot_.resize(n), member_.resize(n), order_.resize(n);
    int* const count = start_.of(static_cast<std::size_t>(bins_.count()));
    start_.set_zero();
    cuda::launch(device_, cuda::CountInBins{bins_, wide, left, bin_.data(), slot_.data(), count}, n);
    const int all = start_.add_up();
    cuda::launch(device_, cuda::PutInBins{bin_.data(), slot_.data(), start_.before(), member_.data()}, n);
    cuda::launch(device_, cuda::RankInBins{wide, tie, bin_.data(), start_.before(), member_.data(), order_.data()}, n);
    return static_cast<std::size_t>(all);
}

void ClustersOnDevice::make(const Pencils& pencils, const SortedOnDevice& order, const PackedPlace* places,
                            const char* wanted) {
    const auto n = static_cast<std::size_t>(pencils.count());
    cuda::launch(device_, cuda::CountClusters{order.start(), order.in_pencil(), wanted, before_.of(n)}, n);
    const auto count = static_cast<std::size_t>(before_.add_up());
    clusters_.resize(count), pencil_.resize(count);
    cuda::launch(device_,
                 cuda::MakeClusters{order.start(), order.in_pencil(), wanted, before_.before(), clusters_.data(),
                                    pencil_.data()},
                 n);
    cuda::launch(device_, cuda::CentreClusters{pencils, places, pencil_.data(), clusters_.data()}, count);
}

void ListsOnDevice::build(const Pencils& pencils, const Pencils& of_clusters, const PackedPlace* places,
                          const cuda::Array<int>& pencil, cuda::Array<Cluster>& clusters,
                          const std::vector<cuda::DeviceSource>& sources, const Reaches& fixed_point,
                          ListRef Cluster::*list) {
    sources_.upload(sources);
    cuda::SearchNeighbours search{.pencils = pencils,
                                  .of_clusters = of_clusters,
                                  .places = places,
                                  .pencil = pencil.data(),
                                  .clusters = clusters.data(),
                                  .sources = sources_.data(),
                                  .source_count = static_cast<int>(sources.size()),
                                  .reach = fixed_point.far + fixed_point.stale,
                                  .reaches = fixed_point,
                                  .write = false,
                                  .count = count_.of(clusters.size()),
                                  .blocks = nullptr,
                                  .list = list};
    const auto run = [&] { cuda::launch_pairs(device_, search, clusters); };
    run();
    blocks_.resize(static_cast<std::size_t>(count_.add_up()));
    search.write = true, search.count = count_.before(), search.blocks = blocks_.data();
    run();
    NeighbourBlock* const first = blocks_.data();
    chunk_.upload(std::span(&first, 1));
}

std::int64_t ListsOnDevice::live() const {
    std::vector<NeighbourBlock> blocks(blocks_.size());
    blocks_.download(blocks);
    std::int64_t live = 0;
    for (const NeighbourBlock& b : blocks) live += std::popcount(b.live);
    return live;
}

std::vector<int> pencils_of(const std::vector<Cluster>& clusters, const std::vector<std::int32_t>& start) {
    std::vector<int> pencil;
    std::size_t c = 0;
    for (const Cluster& g : clusters) {
        while (start[c + 1] <= g.first) ++c;
        pencil.push_back(static_cast<int>(c));
    }
    return pencil;
}

}  // namespace tw

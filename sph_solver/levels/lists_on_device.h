#pragma once
#include <cstdint>
#include <vector>

#include "sph_solver/cuda/driver.h"
#include "sph_solver/cuda/search.h"
#include "sph_solver/cuda/sorting.h"

namespace tw {

/// Numbers on a device, and for each the sum of all before it.
class RunningSum {
public:
    explicit RunningSum(cuda::Device& device) : device_(device), of_(device), before_(device), sums_(device) {}
    /// So many numbers, to be written.
    int* of(std::size_t n) {
        of_.resize(n);
        return of_.data();
    }
    void set_zero() { of_.set_zero(); }
    std::size_t size() const { return of_.size(); }
    void download(std::span<int> to) const { of_.download(to); }
    /// After they were written; gives the sum of all.
    int add_up();
    const int* numbers() const { return of_.data(); }
    int* marks() { return of_.data(); }             ///< the same, to be changed before they are added up
    int* before() const { return before_.data(); }  ///< one more than there are numbers: the last is the sum of all
    void download_before(std::vector<std::int32_t>& to, std::size_t stride) const;
    std::size_t bytes() const { return of_.bytes() + before_.bytes() + sums_.bytes(); }

private:
    cuda::Device& device_;
    cuda::Array<int> of_, before_, sums_;
};

/// Places sorted by pencils on a device.
class SortedOnDevice {
public:
    SortedOnDevice(cuda::Device& device, const cuda::Bins& bins)
        : device_(device), bins_(bins), start_(device), bin_(device), slot_(device), member_(device), order_(device) {}
    /// Of `n` places; those marked in `left` (null: none) are left out. Gives how many are left.
    std::size_t sort(const WidePlace* wide, const std::uint8_t* left, const std::int64_t* tie, std::size_t n);
    const int* order() const { return order_.data(); }  ///< k-th in order
    const int* start() const { return start_.before(); }
    int in_pencil() const { return bins_.in_pencil; }
    cuda::DeviceSource source(const PackedPlace* places, std::int32_t offset) const {
        return {places, start(), in_pencil(), offset};
    }
    void download_start(std::vector<std::int32_t>& of_pencils) const {
        start_.download_before(of_pencils, static_cast<std::size_t>(in_pencil()));
    }
    std::size_t bytes() const {
        return start_.bytes() + bin_.bytes() + slot_.bytes() + member_.bytes() + order_.bytes();
    }

private:
    cuda::Device& device_;
    cuda::Bins bins_;
    RunningSum start_;
    cuda::Array<int> bin_, slot_, member_, order_;
};

/// Pencils in bins of eight spacings: some 32 particles each.
inline cuda::Bins bins_of(const Pencils& grid, double dp, double unit) {
    const auto height = static_cast<std::int64_t>(8 * dp / unit);
    return {grid, height, static_cast<int>(grid.height / height) + 1};
}

/// Sorted places in clusters, on a device.
class ClustersOnDevice {
public:
    explicit ClustersOnDevice(cuda::Device& device)
        : device_(device), before_(device), clusters_(device), pencil_(device) {}
    /// `wanted`: which pencils; null: all.
    void make(const Pencils& pencils, const SortedOnDevice& order, const PackedPlace* places,
              const char* wanted = nullptr);
    const cuda::Array<Cluster>& clusters() const { return clusters_; }
    cuda::Array<Cluster>& clusters() { return clusters_; }
    std::size_t size() const { return clusters_.size(); }
    const cuda::Array<int>& pencil() const { return pencil_; }  ///< of each cluster
    std::size_t bytes() const { return before_.bytes() + clusters_.bytes() + pencil_.bytes(); }

private:
    cuda::Device& device_;
    RunningSum before_;
    cuda::Array<Cluster> clusters_;
    cuda::Array<int> pencil_;
};

/// Lists of the neighbours of clusters, on a device.
class ListsOnDevice {
public:
    explicit ListsOnDevice(cuda::Device& device)
        : device_(device), count_(device), blocks_(device), chunk_(device), sources_(device) {}
    /// Of all `clusters`, of which the k-th is in the pencil pencil[k] of `of_clusters`, among sources sorted by
    /// `pencils`.
    void build(const Pencils& pencils, const Pencils& of_clusters, const PackedPlace* places,
               const cuda::Array<int>& pencil, cuda::Array<Cluster>& clusters,
               const std::vector<cuda::DeviceSource>& sources, const Reaches& fixed_point,
               ListRef Cluster::*list = &Cluster::list);
    Lists view() const { return {chunk_.data()}; }
    const NeighbourBlock* blocks() const { return blocks_.data(); }
    std::int64_t live() const;  ///< marks of all blocks
    std::size_t bytes() const { return count_.bytes() + blocks_.bytes() + chunk_.bytes() + sources_.bytes(); }

private:
    cuda::Device& device_;
    RunningSum count_;
    cuda::Array<NeighbourBlock> blocks_;
    cuda::Array<NeighbourBlock*> chunk_;
    cuda::Array<cuda::DeviceSource> sources_;
};

/// The pencil in which each of a host's clusters stands; `start`: first place of each pencil.
std::vector<int> pencils_of(const std::vector<Cluster>& clusters, const std::vector<std::int32_t>& start);

}  // namespace tw

#pragma once
// The loops that the threads of one machine share: what the engine does in parallel to particles, clusters, pairs or
// pieces of work goes through one of these, except the evening out of the first packing (even_packing.cpp). Serial
// loops over particles (set-up, files, copies) are written out where they are needed. A device has loops of its own
// (device_loops.h); an effect reaches both through StepView.
//
// A body writes only what belongs to its own index, and sums over particles are those of base/exact_sum.h, which are
// the same in any order: so any number of threads gives the same bits, and any order in which the particles are kept.
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "sph_solver/pair_loops/clusters.h"

namespace tw {

/// Calls `body(i)` for every i < n.
template <class Body>
void for_particles(std::size_t n, const Body& body) {
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < n; ++i) body(i);
}

/// Calls `body(cluster)` for every cluster; for work that is uneven from cluster to cluster.
template <class Body>
void for_clusters(const std::vector<Cluster>& clusters, const Body& body) {
#pragma omp parallel for schedule(dynamic, 16)
    for (std::size_t k = 0; k < clusters.size(); ++k) body(clusters[k]);
}

/// Calls `body(k)` for every k < n; for few, long and uneven pieces of work.
template <class Body>
void for_pieces(std::size_t n, const Body& body) {
#pragma omp parallel for schedule(dynamic, 1)
    for (std::size_t k = 0; k < n; ++k) body(k);
}

/// Calls `body(own, k)` for every k < n, with an `Own` for each thread, which goes with it from one k to the next.
template <class Own, class Body>
void for_pieces_with(std::size_t n, const Body& body) {
#pragma omp parallel
    {
        Own own;
#pragma omp for schedule(dynamic, 4)
        for (std::size_t k = 0; k < n; ++k) body(own, k);
    }
}

/// Calls `body()` once on each of so many threads, all at the same time.
template <class Body>
void on_each_of(int threads, const Body& body) {
#pragma omp parallel num_threads(threads)
    body();
}

/// Runs a pair loop over the neighbours of all clusters: the one that reads and writes `View`.
template <class Variant, class View>
void for_pairs(const Variant& passes, const View& view, std::span<const Cluster> clusters) {
    constexpr std::size_t block = 16;
    const std::size_t blocks = (clusters.size() + block - 1) / block;
#pragma omp parallel for schedule(dynamic, 4)
    for (std::size_t b = 0; b < blocks; ++b)
        passes.run(view, clusters.data() + b * block, static_cast<int>(std::min(block, clusters.size() - b * block)));
}

/// The largest `value(i)` over i < n, or `least`; the same in any order.
template <class Value>
double largest_of(std::size_t n, double least, const Value& value) {
    double largest = least;
#pragma omp parallel for schedule(static) reduction(max : largest)
    for (std::size_t i = 0; i < n; ++i) largest = std::max(largest, value(i));
    return largest;
}

/// Cuts [0, n) into ranges of fixed length and calls `body(part, begin, end)` for each, with a Part of its own. Gives
/// the parts in order: what is taken from them does not depend on the number of threads.
template <class Part, class Body>
std::vector<Part> in_fixed_ranges(std::size_t n, const Body& body) {
    constexpr std::size_t range = 4096;
    std::vector<Part> parts((n + range - 1) / range);
#pragma omp parallel for schedule(static)
    for (std::size_t c = 0; c < parts.size(); ++c) body(parts[c], c * range, std::min(n, (c + 1) * range));
    return parts;
}

/// Calls `add(sum, i)` for every i < n. `Sum` begins at nothing, and is the same in any order: it adds its parts by
/// `+=`, which are those of base/exact_sum.h or whole numbers.
template <class Sum, class Add>
Sum sum_over(std::size_t n, const Add& add) {
    Sum all{};
    const auto add_range = [&](Sum& part, std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) add(part, i);
    };
    for (const Sum& part : in_fixed_ranges<Sum>(n, add_range)) all += part;
    return all;
}

}  // namespace tw

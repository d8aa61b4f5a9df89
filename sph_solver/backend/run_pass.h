#pragma once
#include <algorithm>
#include <vector>

#include "sph_solver/backend/pass_data.h"

namespace tw {

/// Runs a pass over all groups, in parallel; what a group writes is its own, so any number of threads gives the same
/// bits.
template <class Data>
void run_pass(void (*pass)(const Data&, const Group*, int), const Data& data, const std::vector<Group>& groups) {
    constexpr std::size_t block = 16;
    const std::size_t blocks = (groups.size() + block - 1) / block;
#pragma omp parallel for schedule(dynamic, 4)
    for (std::size_t b = 0; b < blocks; ++b)
        pass(data, groups.data() + b * block, static_cast<int>(std::min(block, groups.size() - b * block)));
}

}  // namespace tw

#pragma once
#include "sph_solver/backend/for_particles.h"

namespace tw {

/// The name that for_pairs had.
template <class Data>
void run_pass(void (*pass)(const Data&, const Group*, int), const Data& data, const std::vector<Group>& groups) {
    for_pairs(pass, data, groups);
}

}  // namespace tw

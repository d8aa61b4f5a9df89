#pragma once
#include <cstddef>

#include "sph_solver/domain/kind.h"

namespace tw {

/// How many of a level's particles stand for the water of others, all others are active; and how many of them, and of
/// its own water, are beyond inlet or outlet.
struct KindCounts {
    int buffers = 0, overlap = 0, slaves = 0;
    int under_beyond = 0;  ///< of overlap and slaves
    int water_beyond = 0;  ///< of all but buffer particles

    int under() const { return overlap + slaves; }
    KindCounts& operator+=(const KindCounts& other) {
        buffers += other.buffers, overlap += other.overlap, slaves += other.slaves;
        under_beyond += other.under_beyond, water_beyond += other.water_beyond;
        return *this;
    }
};

/// Adds a particle to them.
struct CountKinds {
    const Kind* kind;
    const double* x;     ///< [m]
    double first, last;  ///< where inlet and outlet are [m]
    KindCounts* counts;
    const char* own = nullptr;  ///< which of them count; null: all

    template <class AddOne>
    void operator()(std::size_t i, const AddOne& add_one) const {
        if (own && !own[i]) return;
        const Kind k = kind[i];
        if (k == Kind::buffer) {
            add_one(&counts->buffers);
            return;
        }
        if (k == Kind::overlap) add_one(&counts->overlap);
        if (k == Kind::slave) add_one(&counts->slaves);
        if (x[i] >= first && x[i] <= last) return;
        add_one(&counts->water_beyond);
        if (stands_for_finer(k)) add_one(&counts->under_beyond);
    }
};

}  // namespace tw

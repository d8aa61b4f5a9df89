#pragma once
#include <cstddef>

#include "sph_solver/domain/kind.h"

namespace tw {

/// How many of a level's particles stand for the water of others, all others are active; and how many of them, and of
/// its own water, are beyond inlet or outlet.
struct KindCounts {
    int guards = 0, band = 0, carried = 0;
    int under_beyond = 0;  ///< of band and carried
    int water_beyond = 0;  ///< of all but guards

    int under() const { return band + carried; }
    KindCounts& operator+=(const KindCounts& other) {
        guards += other.guards, band += other.band, carried += other.carried;
        under_beyond += other.under_beyond, water_beyond += other.water_beyond;
        return *this;
    }
};

/// Adds a particle to them.
struct CountKinds {
    const Kind* kind;
    const double* x;
    double first, last;  ///< where inlet and outlet are [m]
    KindCounts* counts;

    template <class AddOne>
    void operator()(std::size_t i, const AddOne& add_one) const {
        const Kind k = kind[i];
        if (k == Kind::guard) {
            add_one(&counts->guards);
            return;
        }
        if (k == Kind::band) add_one(&counts->band);
        if (k == Kind::carried) add_one(&counts->carried);
        if (x[i] >= first && x[i] <= last) return;
        add_one(&counts->water_beyond);
        if (stands_for_finer(k)) add_one(&counts->under_beyond);
    }
};

}  // namespace tw

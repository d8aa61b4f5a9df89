#pragma once
#include <cmath>
#include <cstddef>

#include "sph_solver/device/kernel_of.h"
#include "sph_solver/equations/vector.h"
#include "sph_solver/pair_loops/clusters.h"
#include "sph_solver/pair_loops/views.h"

namespace tw {

/// Force of a level's water on each dummy of a body [N] (per metre of width in two dimensions): the other side of the
/// pair forces of the last second pair loop (pressure_gradient.h),
///
///   F_j = sum_i V_i V_j (p_i + p_j) F_ij (x_j - x_i)
///
/// over the level's own particles. Lane by lane of the clusters in which the dummies are.
struct ForceOnDummies {
    WaterView water;
    WallView walls;
    double unit;        ///< a fixed-point unit [m]
    std::size_t own;    ///< particles; images come after them
    std::size_t first;  ///< of the body's dummies among all
    Lists lists;
    const Cluster* clusters;
    std::size_t lanes;
    V3<double>* force;  ///< of the body's dummies

    void operator()(std::size_t k) const {
        const Cluster& g = clusters[k / lanes];
        const auto lane = static_cast<std::int32_t>(k % lanes);
        if (lane >= g.size) return;
        const auto dummy = static_cast<std::size_t>(g.first + lane);
        force[dummy] = on(walls.place[first + dummy], walls.p[first + dummy], g.list);
    }

private:
    V3<double> on(const PackedPlace& at, float p, const ListRef& near) const {
        const double support = water.kernel.support();
        const NeighbourBlock* const blocks = lists.blocks(near);
        V3<double> sum{0, 0, 0};
        for (std::int32_t b = 0; b < near.size; ++b)
            for (std::uint32_t bits = blocks[b].live; bits != 0; bits &= bits - 1) {
                const auto i = static_cast<std::size_t>(blocks[b].first + __builtin_ctz(bits));
                if (i >= own) continue;
                const PackedPlace& of = water.place[i];
                const V3<double> r =
                    unit * V3<std::int32_t>{difference(at.x, of.x), difference(at.y, of.y), difference(at.z, of.z)};
                const double r2 = dot(r, r);
                if (r2 >= support * support) continue;
                sum += static_cast<double>(of.volume) *
                       (static_cast<double>(water.stress[i].p) + static_cast<double>(p)) *
                       water.kernel.F(std::sqrt(r2)) * r;
            }
        return static_cast<double>(at.volume) * sum;
    }
};

#define TW_BODY_TASKS(task) task(tw_force_on_dummies, ForceOnDummies)
TW_BODY_TASKS(TW_KERNEL_OF)

}  // namespace tw

#pragma once
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "sph_solver/domain/kind.h"

namespace tw {

/// What a particle has of particles of half the spacing in its place.
enum class Children : std::uint8_t {
    none = 0,
    all = 1,
    some = 2  ///< has been out of their reach; those may be there still
};

/// How the fields of a guard change in time, from the coarser level, and what that level knows of its surroundings.
struct Trend {
    float u = 0, v = 0, w = 0;  ///< [m/s2]
    float drho = 0;             ///< [kg/m3/s]
    float support = 1;          ///< kernel support of the coarser particles near [-]: whether it is at a free surface
};

/// Where a particle stood when its distance from the edge of a zone was last worked out, and how far that edge had come.
struct EdgeDistance {
    float x = std::numeric_limits<float>::quiet_NaN(), y = 0, z = 0;  ///< [m]; not a number: it never was
    float outside = 0;                                                ///< Zone::outside there [m]
    float by = 0, turn = 0;                                           ///< sums of Zone::Shift since the start
};

/// The state of all particles, structure of arrays, kept sorted in space. Positions in double precision; density as
/// the deviation from rho0, so that single precision loses nothing.
struct Particles {
    std::vector<double> x, y, z;   ///< [m]
    std::vector<float> u, v, w;    ///< [m/s]
    std::vector<float> drho;       ///< rho - rho0 [kg/m3]
    std::vector<std::int64_t> id;  ///< never reused
    std::vector<Kind> kind;
    // of a level that has a coarser one, else empty
    bool has_coarser = false;
    std::vector<Trend> trend;             ///< meaningful for guards
    std::vector<EdgeDistance> from_edge;  ///< of the own zone
    // of a level that has a finer one, else empty
    bool has_finer = false;
    std::vector<Children> children;
    std::vector<float> compression;             ///< of band: rate of the finer level's density there [kg/m3/s]
    std::vector<EdgeDistance> from_finer_edge;  ///< of the finer level's zone

    std::size_t size() const { return x.size(); }

    /// Applies `f` to each array; every operation on whole particles goes through here.
    template <class Function>
    void for_each_array(Function f) {
        f(x), f(y), f(z), f(u), f(v), f(w), f(drho), f(id), f(kind);
        if (has_coarser) f(trend), f(from_edge);
        if (has_finer) f(children), f(compression), f(from_finer_edge);
    }
    void add(double px, double py, double pz, float pu, float pdrho, std::int64_t pid, Kind pkind) {
        x.push_back(px), y.push_back(py), z.push_back(pz);
        u.push_back(pu), v.push_back(0), w.push_back(0);
        drho.push_back(pdrho), id.push_back(pid), kind.push_back(pkind);
        if (has_coarser) trend.emplace_back(), from_edge.emplace_back();
        if (has_finer) children.push_back(Children::none), compression.push_back(0), from_finer_edge.emplace_back();
    }
    /// New order: particle k becomes what particle order[k] was; particles not named are dropped.
    void reorder(const std::vector<std::int32_t>& order) {
        for_each_array([&](auto& array) {
            auto old = std::move(array);
            array = {};
            array.resize(order.size());
#pragma omp parallel for schedule(static)
            for (std::size_t k = 0; k < order.size(); ++k) array[k] = old[static_cast<std::size_t>(order[k])];
        });
    }
};

}  // namespace tw

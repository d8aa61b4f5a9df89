#pragma once
#include <cstddef>
#include <cstdint>

#include "sph_solver/domain/kind.h"
#include "sph_solver/equations/vector.h"
#include "sph_solver/fields/quantities.h"
#include "sph_solver/loops/link_map.h"
#include "sph_solver/loops/pack_state.h"
#include "sph_solver/loops/surface_excess.h"

namespace tw {

/// Which particles of a level give fields to places of another level's: its own water; that and what stands for a finer
/// level's; all, buffer particles included.
enum class Giving : std::uint8_t { active, not_buffers, all };

/// What is asked of a level at places that are none of its particles.
struct Asking {
    Giving of = Giving::active;
    double apart = 1;           ///< roughly, in spacings of the level: places near each other are worked out together
    double density_before = 0;  ///< the density as it was so long before the last evaluation [s], by its rate there
    bool want_compression = false;
    /// The mean Shepard sum is given, and this taken off the densities of the particles. Null: neither, as before
    /// the level's first pair loop, when its particles may stand in another order than when their supports were found.
    const SurfaceExcess* without = nullptr;
};

/// What a level's particles and their images give, one after another in the order of the level.
struct TakeGiving {
    const PackedPlace* place;
    const PackedVelocityDensity* motion;
    const PackedShiftSupport* shift;
    const float* density_rate;  ///< null: there is none, and it is not asked for [kg/m3/s]
    const Kind* kind;
    const Link* links;
    std::size_t n;  ///< particles; images are those of `links`
    Giving of;
    double density_before;  ///< of Asking [s]
    SurfaceExcess without;
    double row;  ///< ParticleSystem::density_of_row [kg/m3]
    PackedPlace* to_place;
    PackedVelocityDensity* to_motion;
    float* known_support;  ///< null: it is not asked for, and nothing is taken off [-]
    float* rate;           ///< null: it is not asked for [kg/m3/s]

    std::size_t source_of(std::size_t i) const { return i < n ? i : static_cast<std::size_t>(links[i - n].index); }
    bool counts(std::size_t i) const {
        const Kind own = kind[source_of(i)];
        return of == Giving::all || is_active(own) || (of == Giving::not_buffers && own != Kind::buffer);
    }
    /// As the k-th of those that count.
    void put(std::size_t i, std::size_t k) const {
        const std::size_t source = source_of(i);
        to_place[k] = place[i];
        PackedVelocityDensity& r = to_motion[k] = motion[i];
        if (rate) rate[k] = density_rate[source];
        if (density_before > 0)
            r.drho -= static_cast<float>(density_before * static_cast<double>(density_rate[source]));
        if (!known_support) return;
        known_support[k] = shift[source].support;
        r.drho -= static_cast<float>(row * without.of(static_cast<double>(known_support[k])));
    }
};

/// What is known at a place of another level's.
struct Given {
    PackedVelocityDensity value;
    float support;       ///< sum_j V_j W_j of the particles that give [-]
    float mean_support;  ///< of those near, each with its own surroundings [-]; 0 unless asked for
    float compression;   ///< 0 unless asked for [kg/m3/s]

    /// Below this Shepard sum the other level has no water at a place: half of what a plane free surface leaves.
    static constexpr float no_water = 0.25f;
    bool known() const { return support >= no_water; }
};

/// Water that leaves its level's zone becomes a buffer particle where the coarser level covers it, half a fine spacing
/// below a plane free surface included; else it goes on as spray.
struct BecomeBuffer {
    static constexpr float covered = 0.5f;
    Kind* kind = nullptr;

    /// Whether it has.
    bool operator()(std::size_t i, const Given& given) const {
        if (given.support < covered) return false;
        kind[i] = Kind::buffer;
        return true;
    }
};

/// Of particles that a level gave its fields to.
struct Followed {
    double fastest2 = 0;       ///< the largest square of their speeds before, of buffer particles [m2/s2]
    std::int64_t orphans = 0;  ///< without water of the other level near

    Followed& operator+=(const Followed& other) {
        fastest2 = fastest2 < other.fastest2 ? other.fastest2 : fastest2;
        orphans += other.orphans;
        return *this;
    }
};

inline double speed2(const StateView& p, std::size_t i) {
    const double u = p.u[i], v = p.v[i], w = p.w[i];
    return u * u + v * v + w * w;
}

/// Where a particle will be after so long [s], as it moves now.
inline V3<double> place_ahead(const StateView& p, std::size_t i, double time) {
    return {p.x[i] + time * static_cast<double>(p.u[i]), p.y[i] + time * static_cast<double>(p.v[i]),
            p.z[i] + time * static_cast<double>(p.w[i])};
}

/// What a buffer particle becomes until its level has moved as far as the coarser one, see Refinement::prolong.
struct FollowCoarser {
    StateView p{};
    Trend* trend = nullptr;
    SurfaceExcess excess{};            ///< a fine surface's comes in place of a coarse one's
    double row = 0;                    ///< of the buffer particle's level [kg/m3]
    double moved = 0, compressed = 0;  ///< [s]
    V3<float> fall{};                  ///< acceleration of what has no water near [m/s2]

    void operator()(std::size_t i, const Given& given) const {
        if (!given.known()) {
            trend[i] = {fall.x, fall.y, fall.z, 0, 0};
            return;
        }
        PackedVelocityDensity to = given.value;
        to.drho += static_cast<float>(row * excess.of_child(static_cast<double>(given.mean_support)));
        const auto rate = [](float after, float now, double time) {
            return time > 0 ? static_cast<float>((static_cast<double>(after) - static_cast<double>(now)) / time) : 0;
        };
        if (compressed <= 0) p.drho[i] = to.drho;
        trend[i] = {rate(to.u, p.u[i], moved), rate(to.v, p.v[i], moved), rate(to.w, p.w[i], moved),
                    rate(to.drho, p.drho[i], compressed), given.mean_support};
    }
};

/// What a particle under the zone of a finer level becomes, see Refinement::restrict_over.
struct FollowFiner {
    StateView p{};
    const Kind* kind = nullptr;
    const PackedShiftSupport* shift = nullptr;
    float* compression = nullptr;  ///< [kg/m3/s]
    SurfaceExcess excess{};
    double row = 0;    ///< of the particle's level [kg/m3]
    V3<float> fall{};  ///< what the velocity of one that has no water near changes by [m/s]

    void operator()(std::size_t i, const Given& given) const {
        if (given.known()) {
            const PackedVelocityDensity& r = given.value;
            set(i, r.u, r.v, r.w, r.drho + static_cast<float>(row * excess.of(static_cast<double>(shift[i].support))));
            compression[i] = given.compression;
            return;
        }
        compression[i] = 0;
        if (kind[i] == Kind::slave) set(i, p.u[i] + fall.x, p.v[i] + fall.y, p.w[i] + fall.z, 0);
    }

private:
    void set(std::size_t i, float u, float v, float w, float drho) const {
        p.u[i] = u, p.v[i] = v, p.w[i] = w, p.drho[i] = drho;
    }
};

}  // namespace tw

#pragma once
#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sph_solver/bodies/walls.h"
#include "sph_solver/domain/extremes.h"
#include "sph_solver/domain/level_setup.h"
#include "sph_solver/domain/schedule.h"
#include "sph_solver/domain/surroundings.h"
#include "sph_solver/effects/effect.h"
#include "sph_solver/fields/particles.h"
#include "sph_solver/ghosts/ghosts.h"
#include "sph_solver/ghosts/open_boundaries.h"
#include "sph_solver/levels/control_volume.h"
#include "sph_solver/loops/after_first_pair_loop.h"
#include "sph_solver/loops/at_edge.h"
#include "sph_solver/neighbours/list_life.h"
#include "sph_solver/neighbours/pencils.h"
#include "sph_solver/pair_loops/interpolate.h"
#include "sph_solver/pair_loops/views.h"

namespace tw {

template <class Wave>
struct WaveOfInlet;

struct EffectOptions;

/// Who stands where, and who meets whom. Where a device makes the steps only what the host has asked for is here, and
/// of the clusters those at walls.
struct Neighbours {
    std::vector<std::int32_t> start;  ///< first particle of each pencil
    std::vector<Cluster> clusters;
    NeighbourLists lists;
    ListLife life;
};

/// What the particles of a level are: their state, kernel and material, the walls, images and effects that act on them.
/// Data for those who make the steps (step_maker.h) and share the particles among ranks (rank_share.h): what is done
/// with it, and in which order, is theirs and Level's. Others read it through Level::system, but for the
/// particles: while a device makes the steps those here may be of a step long gone, and Level::fields has them fetched.
struct ParticleSystem {
    /// As that of Level.
    ParticleSystem(const Surroundings& surroundings, LevelSetup material, const EffectOptions& options,
                   const Bodies& all_bodies, const Passes& variant, const Fluid& fluid);
    ParticleSystem(const ParticleSystem&) = delete;

    const Surroundings& around;
    LevelSetup setup;
    const Bodies& bodies;
    const Passes& passes;
    std::vector<std::unique_ptr<Effect>> effects;

    double h, mass;           ///< smoothing length [m]; of one particle [kg]
    double time = 0, dt = 0;  ///< [s]
    std::int64_t steps = 0;
    Kernel kernel;
    float given_back;  ///< [m], a of WaterCompleteness
    FixedPoint fixed_point;
    PencilGrid grid;
    Particles particles;
    Ghosts ghosts;
    Walls walls;
    double wall_speed = 0;  ///< of the fastest dummy at the last evaluation [m/s]
    Neighbours near;
    std::optional<ControlVolume> control;
    Ledger ledger;
    Extremes extremes;

    // --- what loops over particles and pairs read and write: the host's arrays
    StateView state_view() {
        Particles& p = particles;
        return {p.x.data(), p.y.data(), p.z.data(), p.u.data(), p.v.data(), p.w.data(), p.drho.data()};
    }
    ToFixedPoint to_fixed_point() const {
        const Vec3& o = fixed_point.origin;
        return {o.x(), o.y(), o.z(), fixed_point.per_metre, static_cast<float>(mass), static_cast<float>(setup.rho0)};
    }
    WaterView water_view() const;
    WallView wall_view() const;
    FirstPairLoopData first_pair_loop_data();
    SecondPairLoopData second_pair_loop_data(double t);
    ExtrapolateData extrapolation() const;  ///< from the present packed arrays; the caller says where to
    InterpolateData interpolation() const;  ///< the caller says of whom, where to and what
    StepView step_view(double t, const Halo& halo);

    // --- coefficients of the pair loops, for who adds other pairs to them
    float inv_W_dp() const { return static_cast<float>(1 / kernel.W(setup.dp)); }  ///< see FirstPairLoopData
    float artificial_viscosity() const {  ///< see SecondPairLoopData::viscosity
        return static_cast<float>(setup.alpha * setup.state_equation.c0 * setup.rho0 / 2);
    }
    float tension_control_from() const {  ///< see SecondPairLoopData
        return setup.tension_control ? static_cast<float>(setup.shifting_support)
                                     : SecondPairLoopData{}.tension_control_from;
    }

    // --- what loops over particles do with the fields of the maker of the steps
    LacksSupport lacks_support(const FieldsView& f) const {
        return {f.kind, f.trend, f.shift_support, setup.surface_support};
    }
    AfterFirstPairLoop after_first_pair_loop(const FieldsView& f, double compress, double drift) const;
    /// The caller says where to.
    TakeGiving giving(const FieldsView& f, const Link* links, std::size_t n, const Asking& asking) const;

    // --- how far they look [m]
    /// Distance from which a neighbour may come within the support during `drift` [s].
    double reach_among(double drift) const { return kernel.support() + 2 * drift * near.life.relative_speed; }
    double reach_to_walls(double drift) const { return kernel.support() + drift * (extremes.speed + walls.fastest()); }
    /// That of particle lists that are made now, by how the last step has left particles and walls.
    double slack_of_lists() const;
    /// How far lists that are made now look among particles, and between those and walls.
    struct ReachesOfLists {
        Reaches among, to_walls;
    };
    ReachesOfLists reaches_of_lists(double drift) const;
    double reach_of_normals() const { return 2 * kernel.support() + setup.dp; }  ///< of the nearest walls
    /// Of points that see the particles by a kernel. These may be elsewhere than when they were sorted (`stale`), with
    /// a margin, because the travel is that of particles that the water's equations move: what others come farther is
    /// missing at the rim of the kernel, where it weighs (0.1 dp / 2h)^4 at most.
    Reaches reaches_of_points(const Kernel& of) const;
    Reaches reaches_of_interpolation() const;
    double reach_of_others() const;  ///< how far other levels look in this one while its lists hold

    /// Speed away from the wall that particle i has near, relative to that wall, when it moves with `u` [m/s].
    double leaving(std::size_t i, const V3<double>& u) const {
        const Particles& p = particles;
        const V3<double> n = normal_of(p.wall_normal[i]);
        const double of_water = dot(u, n);
        if (p.wall_body.empty()) return of_water;
        const std::int32_t triangle = p.wall_triangle.empty() ? -1 : p.wall_triangle[i];
        const Vec3 of_wall = walls.velocity_at(p.wall_body[i], {p.x[i], p.y[i], p.z[i]}, triangle);
        return of_water - dot(V3<double>{of_wall.x(), of_wall.y(), of_wall.z()}, n);
    }
    bool inlet_has_wave() const { return around.stream && around.stream->wave; }
    /// Calls `use` with the wave of an inlet that has one, as loops take it (loops/inlet_wave.h).
    template <class Use>
    void with_wave_of_inlet(const Use& use) const {
        const double c0 = setup.state_equation.c0;
        const Stream::Wave& wave = *around.stream->wave;
        std::visit(
            [&]<class Wave>(const Wave& of) {
                use(WaveOfInlet<Wave>{of, wave.gravity, setup.rho0, 1 / (c0 * c0)});
            },
            wave.of);
    }
    double stream_velocity(double t) const { return around.stream ? around.stream->velocity(t) : 0; }
    /// The larger of the fastest particle's speed and the stream's [m/s].
    double reference_speed() const { return std::max(extremes.speed, stream_velocity(time)); }
    /// Acceleration of all water alike now: gravity and the stream's [m/s2].
    Vec3 body_force() const;
    /// Density that the weight of one row of particles makes at rest, rho0 g dp / c0^2 [kg/m3].
    double density_of_row() const;
    const Comm& ranks() const { return around.ranks ? *around.ranks : Comm::alone(); }
    std::int64_t live_pairs(const Cluster& g) const;  ///< that each of a cluster's particles meets, useful or not
    std::string text_of_failure(std::size_t i, const std::string& what) const;
    double bytes() const;  ///< of the host's memory
};

}  // namespace tw

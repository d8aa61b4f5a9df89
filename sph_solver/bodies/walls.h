#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "sph_solver/bodies/body.h"
#include "sph_solver/bodies/load.h"
#include "sph_solver/domain/level_setup.h"
#include "sph_solver/domain/surroundings.h"
#include "sph_solver/loops/nearest_wall.h"
#include "sph_solver/neighbours/pencils.h"
#include "sph_solver/parallel/halo.h"

namespace tw {

/// The bodies as one level of particles sees them: their dummies, which of them have water near, the normals along
/// which they act, and what the level does to each of them.
class Walls {
public:
    /// `bodies` must outlive this. `kernel_support`: 2h of the level [m]; `lanes`: of its passes.
    Walls(const Bodies& bodies, const Surroundings& around, const LevelSetup& level, double kernel_support,
          const PencilGrid& grid, const FixedPoint& fixed_point, int lanes);

    bool empty() const { return place_.empty(); }
    std::size_t size() const { return place_.size(); }
    const std::vector<PackedPlace>& places() const { return place_; }
    std::vector<float>& pressures() { return p_; }
    const std::vector<float>& pressures() const { return p_; }
    /// Velocity of the dummies' surface along itself; empty: no body slides.
    const std::vector<PackedVelocityDensity>& sliding() const { return sliding_; }
    /// Velocity and acceleration of the bodies at the dummies; null: all bodies are fixed.
    const WallVelocity* velocities() const { return velocity_.empty() ? nullptr : velocity_.data(); }
    const WallAcceleration* accelerations() const { return acceleration_.empty() ? nullptr : acceleration_.data(); }
    /// The dummies of body b are those from body_end()[b - 1] (0) up to body_end()[b].
    const std::vector<std::int32_t>& body_end() const { return body_end_; }
    Lists lists() const { return lists_.view(); }                     ///< of the level's clusters among the dummies
    const NeighbourLists& neighbour_lists() const { return lists_; }  ///< the same

    /// The dummies of one body, sorted by pencil. Clusters and lists count from `first`.
    struct Part {
        std::size_t first = 0;            ///< of all dummies
        std::vector<std::int32_t> start;  ///< first dummy of each pencil
        std::vector<Cluster> clusters;
        std::vector<Cluster> near_water;  ///< those that have water within reach
        NeighbourLists water;           ///< their neighbours among the level's particles
    };
    const std::vector<Part>& parts() const { return parts_; }

    bool move() const { return !velocity_.empty(); }  ///< some body is not fixed
    /// Whether the walls nearest to particles are found anew while lists are kept (docs/decisions/060): else bodies that
    /// move make energy. Not where none moves, and not of elastic ones, whose surface is noted with the lists alone.
    bool found_at_every_step() const { return move() && !any_deformable(); }
    /// The largest speed of a dummy now [m/s].
    double fastest() const;
    bool any_deformable() const { return any_deformable_; }  ///< some body changes its shape
    bool press() const { return press_; }                    ///< some body presses on particles (wall_pushes.h)
    /// Of the surface of a body at a place, as `note_motions` found it [m/s]. `triangle`: of the surface, there.
    Vec3 velocity_at(std::size_t body, const Vec3& x, std::int32_t triangle) const {
        return attached_[body]->surface_velocity(x, triangle);
    }
    /// Of all bodies, as `note_motions` found them; for rigid ones. Empty: none moves.
    std::vector<WallMotion> motions() const;
    /// Looks at how the bodies move now.
    void note_motions();
    /// Puts the dummies of bodies that move where those are now, with their velocities and accelerations.
    void follow(const FixedPoint& fixed_point);
    /// The same, with the dummies sorted anew; lists are due after it.
    void sort(const PencilGrid& grid, const FixedPoint& fixed_point, int lanes);
    /// Adds gravity - f to the accelerations of the dummies, so that water at rest against them presses as under the
    /// force f of a tank that moves. After `follow`.
    void feel(const FrameForce& f, const Vec3& gravity);
    /// The body's dummies as points that go with it; null where all bodies are fixed.
    const Attached* attached(std::size_t body) const { return attached_.empty() ? nullptr : attached_[body].get(); }
    Dummies dummies(std::size_t body) const;  ///< as they stood at the start; of one that deforms without places

    /// Lists anew: of the level's `clusters`, which are those of the first of its `sources`, among the dummies, and of
    /// the dummies in the `own` pencils among the sources.
    void find_neighbours(const Passes& passes, const PencilGrid& grid, const FixedPoint& fixed_point,
                         std::vector<Cluster>& clusters, const std::vector<Source>& sources, const Reaches& reaches,
                         const std::function<bool(int pencil)>& own);
    /// The halo exchange of dummies: each is worked out by the rank whose pencil it stands in.
    void set_halo(const Comm& ranks, const Decomposition& pencils);
    const Halo& halo() const { return halo_; }
    /// Leaves in those lists who is within `reach` [fixed-point units] now.
    void prune(const Passes& passes, const PackedPlace* particles, const std::vector<Cluster>& clusters, double reach);

    using Nearest = NearestWall;
    /// The wall nearest to a place `x` within `reach` [m], where bodies are now, as it acts on water of velocity `u`.
    Nearest nearest(const Vec3& x, const Vec3& u, double reach) const;

    /// What the pair loops have left of each cluster's load: one WallLoad for each body that the cluster has in reach.
    std::vector<WallLoad>& cluster_loads() { return cluster_loads_; }
    std::size_t cluster_load_count() const { return cluster_loads_.size(); }
    std::size_t bytes() const;

    /// What the level does to each body: of the last evaluation and, after a step, with what its walls had to hold.
    const std::vector<Load>& loads() const { return loads_; }
    void set_loads(std::vector<Load> of_bodies) { loads_ = std::move(of_bodies); }
    void add_load(std::size_t body, const Load& load) { loads_[body] += load; }
    /// Forces on places of bodies that press on particles, of the last evaluation.
    const std::vector<WallPush>& pushes() const { return pushes_; }
    void set_pushes(std::vector<WallPush> pushes) { pushes_ = std::move(pushes); }

private:
    /// Index of the dummy after the last of a body.
    std::size_t end_of(std::size_t body) const { return static_cast<std::size_t>(body_end_[body]); }

    const Bodies& bodies_;
    bool two_dimensional_, any_deformable_ = false, press_ = false;
    std::vector<PackedPlace> place_;  // body after body, each sorted by pencil
    std::vector<float> p_;
    std::vector<PackedVelocityDensity> sliding_;
    // empty where all bodies are fixed; accelerations and points are there in a tank that moves, too
    std::vector<WallVelocity> velocity_;
    std::vector<WallAcceleration> acceleration_;
    std::vector<std::unique_ptr<Attached>> attached_;  // the dummies of each body

    std::vector<std::int32_t> body_end_;
    std::vector<Part> parts_;  // of each body
    NeighbourLists lists_;
    Halo halo_;
    std::vector<WallLoad> cluster_loads_;
    std::vector<Load> loads_;  // on each body
    std::vector<WallPush> pushes_;
};

}  // namespace tw

#pragma once
#include <memory>
#include <span>
#include <vector>

#include "sph_solver/backend/device_loops.h"
#include "sph_solver/bodies/wall_pushes.h"
#include "sph_solver/levels/particle_system.h"
#include "sph_solver/levels/rank_share.h"
#include "sph_solver/levels/step_maker.h"

namespace tw {

/// What a level's water does to bodies: sums over the particles that the second pair loop has left, which become the
/// loads of ParticleSystem::walls.
class LevelLoads {
public:
    /// All but the schedule must outlive this; another maker may take the place of the one that `steps` owns.
    LevelLoads(ParticleSystem& system, const RankShare& share, const std::unique_ptr<StepMaker>& steps,
               const Schedule& schedule)
        : system_(system), share_(share), steps_(steps), in_stages_(!schedule.stages().empty()) {}

    /// After the second pair loop. Of several ranks, loads on bodies that stay where they are may wait for the end of
    /// the step: nobody asks for them before.
    void gather(const Vec3& moment_reference);
    /// Sums of this rank that wait to be added to those of the others; empty: none wait.
    std::span<PushSum> waiting() { return waiting_; }
    /// They have been added: now they are the loads.
    void settle(const Vec3& moment_reference);
    /// Of the level's water on the dummies of one body, in the order in which the walls hold them
    /// (loops/force_on_dummies.h) [N]. Their sum is the pressure's part of the body's load, to the rounding of single
    /// precision; what edges release (edge_release.h) is not in them.
    std::vector<Vec3> on_dummies(std::size_t body);

private:
    WallPushes push_particles();
    /// Of all ranks: pressed, rubbed and by bodies, one for each body.
    void set_loads(std::span<const PushSum> sums, const Vec3& moment_reference);
    void add_archimedes(std::size_t b, const Vec3& moment_reference, Load& load) const;

    ParticleSystem& system_;
    const RankShare& share_;
    const std::unique_ptr<StepMaker>& steps_;
    bool in_stages_;
    std::vector<PushSum> waiting_;
    LoopArray<V3<double>> forces_on_dummies_;
};

}  // namespace tw

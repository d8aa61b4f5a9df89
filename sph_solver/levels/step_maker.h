#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "base/exact_sum.h"
#include "base/vec3.h"
#include "sph_solver/bodies/load.h"
#include "sph_solver/effects/effect.h"
#include "sph_solver/levels/edge_steps.h"
#include "sph_solver/levels/sorted_places.h"
#include "sph_solver/loops/count_kinds.h"
#include "sph_solver/loops/move.h"
#include "sph_solver/loops/pressed.h"
#include "sph_solver/pair_loops/views.h"

namespace tw {

/// What a range of particles adds to the extremes and sums of a step.
struct Moved : MovedExtremes {
    // per unit of particle mass
    ExactVectorSum crossed{};          ///< momentum into the control volume [m/s]
    std::vector<PushSum> on_bodies{};  ///< impulse of particles held at the wall of each of them [m/s]; empty: none
    std::vector<WallImpulse> on_elastic{};
    std::vector<std::size_t> by{};  ///< who gave each of those
    std::int64_t held = 0;
};

/// Who makes the parts of a level's step: this processor (on_processor.h) or a device (on_device.h). Level says in
/// which order, and lets effects act and ranks exchange between them.
///
/// The host's particles are the valid ones on a processor. A device keeps particles, packed arrays and lists
/// in its memory, and copies them to the host when it is asked for them.
class StepMaker : public EdgeSteps {
public:
    // --- between the host's particles and those of who makes the steps
    virtual void copy_all_to_host() = 0;
    virtual void copy_motion_to_host() = 0;  ///< positions, velocities and kinds alone
    virtual void copy_to_host(const std::vector<std::size_t>& particles) = 0;  ///< what Move changes
    /// The host's copy is the valid one from now on: it has changed the state of particles, or holds others.
    virtual void note_changed_state() = 0;
    virtual KindCounts count(CountKinds kinds) = 0;  ///< of the own particles; completed by the arrays of who counts
    virtual double bytes_on_device() const = 0;

    // --- how particles find each other
    /// Packed arrays of the present positions, and lists that are valid for a drift of `drift` [s]: made anew.
    virtual void make_lists(double drift) = 0;
    virtual void pack_state() = 0;
    virtual void prune(double drift) = 0;         ///< lists kept, with those within reach during the drift
    virtual void find_walls() = 0;                ///< nearest to particles, lists kept; make_lists finds them too
    virtual std::int64_t live_pairs() const = 0;  ///< that the pair loops visit
    /// Those of its clusters that have particles of another level within reach [m], with lists of these as
    /// Cluster::list.
    struct Near {
        Lists lists{};
        std::span<const Cluster> clusters{};
    };
    /// `room`: keeps the lists on a processor; a device has room for one other level at a time.
    struct RoomForLists {
        NeighbourLists lists;
        std::vector<Cluster> clusters;
    };
    virtual Near find_neighbours(StepMaker& other, const Reaches& reaches, RoomForLists& room) = 0;

    // --- an evaluation of the rates, in this order
    virtual StepView step_view(double t) = 0;                  ///< for loops of others
    virtual void first_pair_loop(const OtherSums* other) = 0;  ///< see pair_loops/right_hand_side.h
    virtual void exchange_first_sums() = 0;                    ///< what it has left, with the other ranks
    virtual void mark_surface() = 0;
    virtual void compress(double compress, double drift) = 0;  ///< see loops/after_first_pair_loop.h
    virtual void refresh_images(double t) = 0;                 ///< after pressures have changed
    virtual void press_walls() = 0;                            ///< pressures of dummies
    virtual void exchange_pressures() = 0;                     ///< of dummies
    virtual void second_pair_loop(double t) = 0;
    virtual void exchange_rates() = 0;      ///< once all have added to them, with the shift
    virtual void copy_loads_to_host() = 0;  ///< of the clusters at walls

    // --- the loads
    virtual Vec3 centre_of_cluster(std::size_t k) const = 0;  ///< of the host's clusters [m]
    /// Particles for which the condition holds, completed by the arrays of who makes the steps; their state is on the
    /// host then. Their indices, in ascending order.
    virtual std::vector<std::int32_t> copy_pressed_to_host(MayBePressed condition) = 0;
    /// Adds the accelerations [m/s2] to the rates of these particles.
    virtual void push(const std::vector<std::int32_t>& which, const std::vector<V3<float>>& accelerations) = 0;

    // --- the end of a step
    /// `hold(i, moved)` looks after a particle, on the host, that a wall may have to hold.
    using Hold = std::function<void(std::size_t, Moved&)>;
    virtual std::vector<Moved> move(const Move& of_host, const Hold& hold) = 0;

    // --- what others ask of the particles
    /// Pressure and Shepard sum at points, sorted as particles are. `to` describes all but the water.
    virtual void sample(SortedPlaces& points, const ExtrapolateData& to) = 0;
};

}  // namespace tw

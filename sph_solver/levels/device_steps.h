#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/vec3.h"
#include "sph_solver/effects/effect.h"
#include "sph_solver/levels/edge_steps.h"
#include "sph_solver/loops/count_kinds.h"
#include "sph_solver/loops/move.h"
#include "sph_solver/loops/pressed.h"
#include "sph_solver/sweeps/views.h"

namespace tw {

/// The steps of a level on a device. Particles, packed arrays (records) and lists stay in its memory, and are copied
/// to the host ("home") when the host asks for them.
class DeviceSteps : public EdgeSteps {
public:
    /// Copies all of it to the host.
    virtual void bring_all_home() = 0;
    virtual void bring_motion_home() = 0;                                    ///< positions, velocities and kinds alone
    virtual void bring_home(const std::vector<std::size_t>& particles) = 0;  ///< what Move changes
    /// The same for the particles for which the condition holds, which the device completes by its own arrays. Returns
    /// their indices, in ascending order.
    virtual std::vector<std::int32_t> bring_pressed_home(MayBePressed condition) = 0;
    /// The host's copy is the valid one from now on: it has changed the state of particles, or holds others.
    virtual void note_changed_state() = 0;

    /// Packed arrays of the present positions, and lists, made anew or kept, that are valid for a drift of `drift` [s].
    virtual void make_lists(double drift) = 0;
    virtual void refresh(double drift) = 0;
    /// Middle of the k-th of the level's groups, which are those at walls [m].
    virtual Vec3 centre_of_group(std::size_t k) const = 0;
    virtual std::int64_t live_pairs() const = 0;  ///< that the pair loops visit
    /// Those of its groups that have particles of another level within reach [m], with lists of these as Group::list.
    /// For one other level at a time: the next call overwrites them.
    struct Neighbours {
        Lists lists;
        std::span<const Group> groups;
    };
    virtual Neighbours find_neighbours(DeviceSteps& other, const Reaches& reaches) = 0;
    /// `other` as in Level::first_sweep.
    virtual void first_sweep(double t, double compress, double drift, const OtherSums* other) = 0;
    /// Copies the loads of the groups at walls to the host.
    virtual void second_sweep(double t) = 0;
    /// Adds the accelerations [m/s2] to the rates of these particles.
    virtual void push(const std::vector<std::int32_t>& which, const std::vector<V3<float>>& accelerations) = 0;
    virtual StepView step_view(double t) = 0;  ///< for loops of others on the device
    struct Moved {
        MovedExtremes extremes;             ///< of all particles except those in `at_walls`
        std::vector<std::size_t> at_walls;  ///< that a wall has to hold; copied to the host, in ascending order
    };
    virtual Moved move(const Move& of_host) = 0;
    virtual void put_back(const std::vector<std::size_t>& held) = 0;  ///< `at_walls`, after the host has held them

    /// Pressure and Shepard sum at points, which are sorted by the level's columns. `to` describes all but the water.
    struct Points {
        const std::vector<PlaceRecord>& places;
        const std::vector<std::int32_t>& start;  ///< first point of each column
        const std::vector<Group>& groups;
    };
    virtual void sample(const Points& points, const Reaches& quanta, const ExtrapolateData& to) = 0;

    virtual KindCounts count(CountKinds kinds) = 0;  ///< completed by the device's own arrays
    virtual double bytes() const = 0;                ///< on the device
};

}  // namespace tw

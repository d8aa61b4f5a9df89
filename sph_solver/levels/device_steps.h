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

/// The steps of a level that a device makes. Particles, records and lists stay there; what is asked of the level comes
/// home when it is asked for.
class DeviceSteps : public EdgeSteps {
public:
    /// What the host has is that of the device from now on.
    virtual void bring_all_home() = 0;
    virtual void bring_motion_home() = 0;  ///< places, velocities and kinds alone
    virtual void bring_home(const std::vector<std::size_t>& particles) = 0;  ///< what Move changes of these
    /// The same of those of whom a condition holds, which says all but of whom; they come out in order.
    virtual std::vector<std::int32_t> bring_pressed_home(MayBePressed condition) = 0;
    /// What the host has counts from now on: it has changed the state of particles, or has others.
    virtual void note_changed_state() = 0;

    /// Records of who is where now, and lists, anew or as they are, that hold for a drift of `drift` [s].
    virtual void make_lists(double drift) = 0;
    virtual void refresh(double drift) = 0;
    /// Middle of the k-th of the level's groups, which are those at walls [m].
    virtual Vec3 centre_of_group(std::size_t k) const = 0;
    virtual std::int64_t live_pairs() const = 0;  ///< that the sweeps visit
    /// Those of its groups that have particles of another level within reach [m], with lists of these as Group::list. For
    /// one other level; until this is asked for again.
    struct Neighbours {
        Lists lists;
        std::span<const Group> groups;
    };
    virtual Neighbours find_neighbours(DeviceSteps& other, const Reaches& reaches) = 0;
    /// `other` as in Level::first_sweep.
    virtual void first_sweep(double t, double compress, double drift, const OtherSums* other) = 0;
    /// Leaves the loads of the groups at walls with the host.
    virtual void second_sweep(double t) = 0;
    /// Adds to their rates.
    virtual void push(const std::vector<std::int32_t>& which, const std::vector<V3<float>>& accelerations) = 0;
    virtual StepView step_view(double t) = 0;  ///< for loops of others on the device
    struct Moved {
        MovedExtremes extremes;             ///< but for those of
        std::vector<std::size_t> at_walls;  ///< whom a wall has to hold: these are home, in order
    };
    virtual Moved move(const Move& of_host) = 0;
    virtual void put_back(const std::vector<std::size_t>& held) = 0;  ///< at_walls, looked after at home

    /// Pressure and kernel support at points, of which `to` says all but where the water is; sorted by the level's columns.
    struct Points {
        const std::vector<PlaceRecord>& places;
        const std::vector<std::int32_t>& start;  ///< first point of each column
        const std::vector<Group>& groups;
    };
    virtual void sample(const Points& points, const Reaches& quanta, const ExtrapolateData& to) = 0;

    virtual KindCounts count(CountKinds kinds) = 0;  ///< which says all but of whom
    virtual double bytes() const = 0;                ///< on the device
};

}  // namespace tw

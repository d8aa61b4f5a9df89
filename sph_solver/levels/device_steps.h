#pragma once
#include <cstddef>
#include <vector>

#include "sph_solver/loops/move.h"

namespace tw {

/// The steps of a level that a device makes. Particles, records and lists stay there from one making of the lists to the
/// next; then the state comes home, and the host sorts, finds neighbours and asks the walls, as it does without a device.
/// What is asked of the level in between comes home when it is asked for.
class DeviceSteps {
public:
    virtual ~DeviceSteps() = default;

    /// What the host has of the state, or of all, is that of the device from now on.
    virtual void bring_state_home() = 0;
    virtual void bring_all_home() = 0;
    virtual void bring_home(const std::vector<std::size_t>& particles) = 0;  ///< what Move changes of these
    /// What the host has counts: it has changed the state of particles, or all particles, and lists follow.
    virtual void note_changed_state() = 0;
    virtual void forget() = 0;
    /// The host has made the lists anew.
    virtual void take_lists() = 0;

    /// Records of who is where now, and lists that hold for a drift of `drift` [s].
    virtual void refresh(double drift) = 0;
    virtual void first_sweep(double compress, double drift) = 0;
    /// Leaves the loads of the groups at walls with the host.
    virtual void second_sweep(double t) = 0;
    struct Moved {
        MovedExtremes extremes;             ///< but for those of
        std::vector<std::size_t> at_walls;  ///< whom a wall has to hold: these are home, in order
    };
    virtual Moved move(const Move& of_host) = 0;
    virtual void put_back(const std::vector<std::size_t>& held) = 0;  ///< at_walls, looked after at home

    virtual double bytes() const = 0;  ///< on the device
};

}  // namespace tw

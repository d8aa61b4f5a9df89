#pragma once
#include <cstdint>
#include <string>

#include "spray/air/air.h"
#include "spray/droplet.h"
#include "spray/extract/breakup.h"
#include "spray/extract/element.h"
#include "spray/extract/gate.h"

namespace tw::spray {

/// How the water of a component becomes droplets.
enum class DropletSize {
    component,  ///< one sphere of the component's volume
    element,    ///< one sphere for each particle or cell, as the study does
    breakup     ///< one sphere, or fragments where the wind on it is too strong
};

struct ExtractOptions {
    /// Distance up to which elements hang together, in spacings [-]. Particles interact up to twice the smoothing
    /// length, 3.1 spacings, but hold nothing together beyond 2.
    double link = 2;
    std::size_t fewest = 1;          ///< elements of a component; smaller ones stay in the ledger
    double largest_diameter = 1e30;  ///< of the sphere of a component's volume [m]; larger ones are lumps, not droplets
    Gate gate;
    /// Every particle or cell beyond the gate counts, whether or not it hangs on the body of water, as a piece of its
    /// own: more than can be droplets, an upper bound.
    bool attached = false;
    /// What is beyond the gate at the first frame is taken too; false: that frame only begins the first interval.
    bool already_beyond = false;
    DropletSize size = DropletSize::component;
    BreakupOptions breakup;
    std::uint64_t seed = 1;         ///< of the fragments
    std::size_t most = 20'000'000;  ///< droplets; more are refused
    Liquid liquid;
    Vec3 gravity{0, 0, -9.81};  ///< [m/s2]
};

/// Where the water of the frames went. Every element of every frame is in exactly one of body, before_gate, lumps,
/// crumbs, earlier and taken, so they add up to `all`; momentum and volume of `droplets` are those of `taken`, to
/// rounding, and so is the kinetic energy with `inner_energy`.
struct Ledger {
    Budget all;                 ///< all water that was looked at, frame by frame
    Budget body;                ///< the largest component; none where attached water counts
    Budget before_gate;         ///< detached (or attached water counts), and not beyond the gate
    Budget lumps;               ///< beyond it, and too large
    Budget crumbs;              ///< beyond it, and of too few elements
    Budget earlier;             ///< beyond it already at the frame before
    Budget taken;               ///< became droplets
    Budget droplets;            ///< what they are
    double inner_energy = 0;    ///< kinetic energy of taken water about the velocity of its component [J]
    double shifted_energy = 0;  ///< potential energy that is lost or won because fragments stand elsewhere [J]
    double returned = 0;        ///< volume of detached water that came back through the gate [m3]
};

/// A lump that a run has taken out by itself.
struct TakenLump {
    Element water;
    std::size_t pieces = 1;   ///< particles that it was
    double inner_energy = 0;  ///< kinetic energy about its velocity [J]
};

/// One frame that was looked at.
struct FrameCount {
    double time = 0;             ///< [s]
    double detached = 0;         ///< volume that does not hang on the body [m3]
    double beyond = 0;           ///< of it beyond the gate [m3]
    double taken = 0;            ///< of it taken as droplets [m3]
    std::size_t components = 0;  ///< detached ones
    std::size_t droplets = 0;
};

struct Extraction {
    std::vector<Droplet> droplets;  ///< let go at the time of their frame
    Ledger ledger;
    std::vector<FrameCount> frames;
};

/// Takes droplets from frames of one run, in the order of time.
///
/// With an open gate every frame is on its own and one is expected: two would count the same water twice. With a gate a
/// component is taken at the first frame at which it is beyond: where its centre, led back over the time since the frame
/// before by its own velocity and gravity,
///
///   x(t - dt) = x - v dt + g dt^2 / 2
///
/// was not. This counts every freely flying component once, without names of particles; the first frame only begins the
/// interval, unless `already_beyond` says otherwise. Components that merge, part or are pushed within an interval can be missed or doubled: FrameCount shows it.
class Extractor {
public:
    /// Throws InputError naming the option that cannot be.
    Extractor(const ExtractOptions& options, const Air& air);
    /// Throws InputError: a frame not later than the one before, a second one with an open gate, or too many droplets.
    void look_at(const WaterFrame& frame);
    /// Takes a lump that is known to be detached and beyond. Times do not fall.
    void take_lump(double time, const TakenLump& lump);
    const Extraction& result() const { return result_; }

private:
    struct Component;
    bool beyond_before(const Component& c, double interval) const;
    void settle(const Component& c, const Budget& sum, const WaterFrame& frame, FrameCount& count);
    void take(const Component& c, const WaterFrame& frame);
    void add_droplet(const Vec3& place, const Vec3& velocity, double volume, double time);

    ExtractOptions options_;
    const Air& air_;
    std::mt19937_64 random_;
    Extraction result_;
    bool begun_ = false;
    double last_time_ = 0;
};

}  // namespace tw::spray

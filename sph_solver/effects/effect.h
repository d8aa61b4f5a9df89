#pragma once
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "sph_solver/backend/device_loops.h"
#include "sph_solver/backend/for_particles.h"
#include "sph_solver/device/kernel_of.h"
#include "sph_solver/effects/kernel_list.h"
#include "sph_solver/fields/particles.h"
#include "sph_solver/ghosts/laws.h"
#include "sph_solver/loops/pack_state.h"
#include "sph_solver/pair_loops/own_sums.h"
#include "sph_solver/pair_loops/passes.h"
#include "sph_solver/pair_loops/views.h"
#include "sph_solver/parallel/comm.h"
#include "sph_solver/parallel/halo.h"

namespace tw {

struct LevelSetup;
struct Surroundings;

TW_EFFECT_PAIR_LOOPS(TW_KERNEL_OF_STRUCT)
TW_EFFECT_TASKS(TW_KERNEL_OF_STRUCT)
TW_EFFECT_LARGEST(TW_KERNEL_OF_STRUCT)
TW_EFFECT_CHOICES(TW_KERNEL_OF_STRUCT)
TW_EFFECT_PAIR_LOOPS_OF_CHOSEN(TW_KERNEL_OF_STRUCT)
TW_IMAGE_TASKS(TW_KERNEL_OF)

/// What an effect sees of one step, and what it may change: the pressure before the forces, and the rates after them.
/// Indices run over the particles, then over their mirror images; wall dummies have their own.
///
/// A device may make the step. All pointers are then its own, so what is done to them is done by the loops below, whose
/// bodies are structs with a line in kernel_list.h. An effect's arrays are LoopArrays.
struct StepView {
    const Surroundings& around;
    const LevelSetup& level;
    std::size_t n, images;  ///< particles, and their mirror images
    StateView p;            ///< to be read
    const Kind* kind;
    FieldsView fields;  ///< all quantities of the particles (fields/field_list.h); null: they have none
    const PackedShiftSupport* shift;
    WaterView water;
    WallView dummies;                ///< of the walls; no place: there are none
    PackedGradientPressure* stress;  ///< may be changed before the forces
    PackedRate* rate;                ///< may be changed after them
    const Passes& passes;
    std::span<const Cluster> clusters;
    /// Dummies in clusters, with lists of the water near them.
    struct DummiesOfBody {
        std::size_t first;  ///< of all dummies; clusters and lists count from it
        Lists water;
        std::span<const Cluster> clusters;
    };
    std::vector<DummiesOfBody> bodies;
    std::size_t dummy_count;
    const PackedVelocityDensity* sliding;  ///< of the dummies' surfaces along themselves; null: none slides
    std::size_t wall_load_count;           ///< see SecondPairLoopData::wall_load
    const Link* links;
    const LinkMap* maps;
    const Comm& ranks;
    const Halo &halo, &dummies_halo;  ///< see `exchange`
    double h, mass, time;             ///< smoothing length [m], of a particle [kg], now [s]
    DeviceLoops* device = nullptr;  ///< null: this process makes the step

    /// Calls `body(i)` for every i < count.
    template <class Body>
    void each(std::size_t count, const Body& body) const {
        if (!device) return for_particles(count, body);
        device->each(body, count);
    }
    /// The largest `value(i)` over i < count, or 0.
    template <class Value>
    double largest(std::size_t count, const Value& value) const {
        if (!device) return largest_of(count, 0, value);
        return device->largest(value, count);
    }
    /// A pair loop over the neighbours of the level's clusters, or of others.
    template <class View>
    void pairs(const View& view, std::span<const Cluster> of) const {
        if (!device) return for_pairs(passes, view, of);
        device->pairs(view, of);
    }
    template <class View>
    void pairs(const View& view) const {
        pairs(view, clusters);
    }
    /// A pair loop over those of the level's clusters of which `choose(cluster)` is true, put into `chosen` in some
    /// order.
    template <class Choose, class View>
    void pairs_where(const Choose& choose, const View& view, LoopArray<Cluster>& chosen) const {
        Cluster* const to = chosen.resize(device, clusters.size());
        if (device) return device->pairs_where(choose, clusters, to, view);
        std::size_t count = 0;
        for (const Cluster& g : clusters)
            if (choose(g)) to[count++] = g;
        for_pairs(passes, view, {to, count});
    }
    /// Room for what a pair loop leaves.
    template <class T>
    OwnSums<T> sums(LoopArray<T>& in, std::size_t count) const {
        return OwnSums<T>(in.resize(device, count));
    }
    /// The same, zero where no pair loop comes.
    template <class T>
    OwnSums<T> zero_sums(LoopArray<T>& in, std::size_t count) const {
        return OwnSums<T>(in.zeros(device, count));
    }
    /// Halo exchange of what a pair loop has left for particles, or for dummies: then loops may read it.
    template <class T>
    T* exchange(const OwnSums<T>& of) const {
        return exchange_by(halo, of.at_);
    }
    template <class T>
    T* exchange_at_dummies(const OwnSums<T>& of) const {
        return exchange_by(dummies_halo, of.at_);
    }
    /// For loops that make nothing of it but the particles' rates: these are exchanged after all effects.
    template <class T>
    T* for_rates(const OwnSums<T>& of) const {
        return of.at_;
    }
    /// Gives images what they have of an array for particles and images, by a law that asks for no place.
    template <Law law, class T>
    void refresh(T* values) const {
        each(images, SeeValues<law, T>{links, maps, n, values});
    }

private:
    template <class T>
    T* exchange_by(const Halo& by, T* values) const {
        if (device)
            device->exchange(by, values, sizeof(T));
        else
            by.exchange(values);
        return values;
    }
};

/// One physical effect that a scene may do without. It is built only when it is on: off, it costs no array, no byte of
/// a restart file and no instruction of the passes, because its sums over neighbours are a pair loop of its own. What
/// it has to remember between steps is a quantity of the particles (`brings`), which a restart file holds as well.
class Effect {
public:
    virtual ~Effect() = default;
    /// What the level's particles have because of it.
    virtual With brings() const { return With::water; }
    /// The first pair loop's sums are there, and the marks at the free surface; densities have not changed yet.
    virtual void after_first_pair_loop(const StepView&) {}
    /// Density and pressure are those of this step; `stress[i].p` of the particles may be changed.
    virtual void change_pressure(const StepView&) {}
    /// All forces of the engine itself are in `rate`; adds to it.
    virtual void add_rates(const StepView&) {}
    /// Largest stable step of this effect alone [s].
    virtual double largest_step(const LevelSetup&, double /*h*/) const {
        return std::numeric_limits<double>::infinity();
    }
    /// What the walls did to the water in `add_rates`, cluster by cluster as in SecondPairLoopData; empty: nothing.
    virtual const std::vector<WallLoad>& wall_loads() const {
        static const std::vector<WallLoad> none;
        return none;
    }
    virtual std::size_t bytes() const { return 0; }
};

}  // namespace tw

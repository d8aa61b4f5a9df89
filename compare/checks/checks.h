#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compare/compare.h"

namespace tw {

/// Soundness checks of one run from its record: finished, particles lost, Mach or Courant number, mass drift (tank,
/// until water is at its open top), largest speed, ventilation, suction on a hull that has edges in air, drag that a
/// prismatic bottom cannot have, spread of the force measures; then the validity checks made in it. Only those
/// whose data the record holds.
std::vector<ValidityCheck> checks_of(const RunRecord& record, const std::string& name);
/// The checks that are not met.
std::vector<ValidityCheck> failed_checks(std::vector<ValidityCheck> checks);

/// The checks of one run, as they are made.
struct CheckList {
    const RunRecord& record;
    const std::string& name;  ///< of the run, for people
    std::vector<ValidityCheck> checks = {};

    /// Met by a value up to the limit.
    void add(std::string check, std::string unit, double value, double limit, std::string remark) {
        checks.push_back({std::move(check), name, std::move(unit), value, limit,
                          value <= limit + 1e-9 * std::abs(limit), std::move(remark)});
    }
};

/// Whether the water is all there and at rest where it should be (water_checks.cpp).
void add_water_checks(CheckList& list);
/// What a hull shows that the resolution or the method gets wrong: air smeared under it, suction at its edges, drag that
/// its bottom cannot have, force measures that differ (hull_checks.cpp).
void add_hull_checks(CheckList& list);

// The measures behind the checks of the water: whether a run keeps the water that its heights, pressures and means take
// for granted. Only of what the record holds.

/// The largest departure of a quantity over a run.
struct Departure {
    double value = 0;  ///< [unit of the function that tells it]
    double time = 0;   ///< [s]
};

/// Of a tank at rest: by how much the water's centre of mass lies below the lowest place that its mass and density allow,
///
///   (z_c,min - z_c) / (z_c,min - z_floor)   [-],   z_c = E_p / (m g)
///
/// z_c,min: filled from the floor up into all that solids at rest leave of the tank, as if all of it were connected, so
/// no water of constant density can be lower, however it moves. In a plain tank of still water it is the share of the
/// volume that is gone. Water that the method compresses by its own weight makes g H / (2 c0^2) of it. Nothing for a
/// stream and a tank that moves.
std::optional<Departure> sunk_below_rest(const RunRecord& record);

/// Of a tank in which nothing moves and whose water stands as low as it can at the start (within half a per cent of its
/// depth): the kinetic energy of the water that should rest, over the energy that it has by its height above the floor,
///
///   E_k / (m g (z_c,min - z_floor))   [-]
std::optional<Departure> motion_at_rest(const RunRecord& record);

/// Of a stream: by how much the mass of the water in the box has changed since the means begin [-]. A mean over a box that
/// fills or empties is the mean of no steady flow.
///
///   without waves     the row that departs most from the first
///   a regular wave    its mean over the last whole period of encounter against that over the first: in a box shorter than
///                     the wave the water swings with it
///   a sea             its mean over the last half of the whole peak periods against that over the first half
///
/// Not a number with waves of which fewer than two whole periods are recorded.
std::optional<Departure> change_of_water_in_box(const RunRecord& record);

/// Of a stream of particles of one size: what its openings let in and out.
struct Throughput {
    double unaccounted =
        0;  ///< particles that came or went otherwise since the start, at the worst; in books that balance 0
    double unaccounted_at = 0;  ///< [s]
    /// Inflow less outflow since the means began, over the inflow [-]; of waves over the last whole periods of encounter,
    /// as in a box shorter than a wave the water swings with it. Nothing where no inflow or no whole period is recorded.
    std::optional<double> surplus;
};
/// Nothing for other runs, and for one that takes water out as droplets.
std::optional<Throughput> throughput(const RunRecord& record);

/// Of a stream without waves at its inlet: how far the mean level of the water in the tenth of the box that is nearest to
/// the inlet lies from the still level, z = 0, in frames from `mean_from` on [m].
std::optional<Departure> level_at_inlet(const RunRecord& record);

}  // namespace tw

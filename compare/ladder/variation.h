#pragma once
#include <optional>
#include <string>
#include <vector>

#include "compare/ladder/ladder.h"

namespace tw {

// Runs with one choice made otherwise, and what they are evidence of.

/// Below this factor in time steps, or in the water's cross section, a choice has not changed what it was to change:
/// the share extrapolated from it would be more than six times the change seen.
inline constexpr double least_change = 1.2;

/// `varied` as a variation of `base`, a run of the same size, where they differ in one choice alone: the sound speed, a
/// shorter time step, a wider box.
std::optional<LadderVariation> variation_between(const LadderRun& base, const LadderRun& varied);

/// Settles what a variation is worth beside the run it varies. Errors of time stepping are taken as of first order, so
/// with r times as many steps taken the share is 1/(1 - 1/r) of the change, r at most what was asked for; below
/// `least_change` the variation is refused as evidence. What walls do to a flow goes with the share of the water's cross
/// section A that a body takes, so with 1/A: of a wider box the share is 1/(1 - A/A_wide), and one that has not grown by
/// `least_change` is refused too. Runs that do not say their steps or their box are believed.
void weigh(LadderVariation& variation, const LadderRun& base);

/// What the variations say of one quantity of side `k`: its own, and the other sides' boxes, relative to the value
/// (at least `scale`).
std::vector<Sensitivity> sensitivities_of(const std::vector<LadderSide>& sides, std::size_t k, const std::string& name,
                                          double finest, double scale);

/// Where the time step did not follow the spacing: the runs' estimate is then one of the spacing alone. Empty: it did.
std::string steps_note(const LadderSide& side);
/// What is to be said of runs that are not similar, because they have other numbers of sizes of particles; empty: they
/// are.
std::string unlike_sizes_note(const LadderSide& side);

/// The quantity of a run, if it has been measured.
const Quantity* find_quantity(const LadderRun& run, const std::string& name);

}  // namespace tw

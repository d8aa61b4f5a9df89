#pragma once
#include <optional>
#include <string>
#include <vector>

#include "compare/grid_study/grid_study.h"

namespace tw {

// The steps in which build_grid_study makes a grid study: sides.cpp, variation.cpp, value.cpp, held.cpp, verdict.cpp.

/// The settings of a record's run.
Family family_of(const RunRecord& record);

/// "delta is 0.1 and 0.2, effect shifting is on and off": what the records show of it.
std::string family_differences(const Family& a, const Family& b);

/// Whether the records show nothing but resolution, domain and duration to differ.
bool same_settings(const Family& a, const Family& b);

/// The runs by method, in the order of methods() and others behind them by name; finest first. Throws InputError: two
/// runs of one method with one spacing, or of two families.
std::vector<GridStudySide> sides_of(std::vector<GridStudyRun> runs);
/// Puts a variation beside the run that it varies. Throws InputError: there is none.
void add_variation(std::vector<GridStudySide>& sides, GridStudyVariation variation);

/// A choice that should not matter, made otherwise: the share of the error that it leaves in the grid study's value is
/// `factor` |value - varied value|, with 1/(1 - 1/r^q) for a choice made finer by r whose error falls with order q.
struct Varied {
    std::string name;   ///< "sound speed x 1.5"
    double factor = 1;  ///< [-]
    double steps = 1;   ///< how many times as many time steps it is to take [-]; 1: they are not what it changes
};
/// `varied` against `base`, where they differ in nothing but the sound speed, a time step made shorter, or a surface
/// captured geometrically, another model whose change counts in full.
std::optional<Varied> variation_between(const Family& base, const Family& varied);
/// `varied` as a variation of `base`, a run of the same size, where they differ in one choice alone: the sound speed, a
/// shorter time step, a wider box.
std::optional<GridStudyVariation> variation_between(const GridStudyRun& base, const GridStudyRun& varied);

/// Settles what a variation is worth beside the run it varies. Errors of time stepping are taken as of first order, so
/// with r times as many steps taken the share is 1/(1 - 1/r) of the change, r at most what was asked for; below
/// a factor of 1.2 the variation is refused as evidence. What walls do to a flow goes with the share of the water's cross
/// section A that a body takes, so with 1/A: of a wider box the share is 1/(1 - A/A_wide), and one that has not grown by
/// that factor is refused too. Runs that do not say their steps or their box are believed.
void weigh(GridStudyVariation& variation, const GridStudyRun& base);

/// What the variations say of one quantity of side `k`: its own, and the other sides' boxes, relative to the value
/// (at least `scale`).
std::vector<Sensitivity> sensitivities_of(const std::vector<GridStudySide>& sides, std::size_t k,
                                          const std::string& name, double finest, double scale);

/// Where the time step did not follow the spacing: the runs' estimate is then one of the spacing alone. Empty: it did.
std::string steps_note(const GridStudySide& side);
/// What is to be said of runs that are not similar, because they have other numbers of sizes of particles; empty: they
/// are.
std::string unlike_sizes_note(const GridStudySide& side);

/// The quantity of a run, if it has been measured.
const Quantity* find_quantity(const GridStudyRun& run, const std::string& name);

/// What the sizes of side `k` say of one quantity: its values, their discretisation error, what other choices change,
/// and what accuracy costs. `scale`: the quantity's own, below which no change of the box is relative to the value.
GridStudyValue value_of(const std::vector<GridStudySide>& sides, std::size_t k, const std::string& name, double scale);

/// Low and high of x, y, z of the run's domain; of x, z in two dimensions [m].
std::vector<double> domain_of(const RunRecord& record);
/// Holds the grid study's values against a measured record, within the time that its runs cover. Throws InputError: of
/// another hull, another tank, or in another unit.
void add_measured(GridStudy& grid_study, const RunRecord& record);
/// Holds them against the formulas of the finest run that has some: the same formula says the same of every size.
void add_references(GridStudy& grid_study);

/// The verdict on one quantity whose values are known, its reason, and the time of runs that would decide it (the rule
/// stands at build_grid_study). `target`: share of the size that the joint interval may have; `scale`: least size.
void judge(GridStudyQuantity& quantity, const std::vector<GridStudySide>& sides, double target, double scale);

}  // namespace tw

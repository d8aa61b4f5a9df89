#pragma once
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "compare/compare.h"
#include "compare/grid_study/cost.h"
#include "compare/uncertainty/convergence.h"

namespace tw {

/// An uncertainty or a change that is no more than the last digits of its value says nothing.
inline bool no_more_than_rounding(double U, double value) { return std::abs(U) <= 1e-9 * std::abs(value); }

/// The settings of a run besides its resolution. Runs of one family differ in resolution alone.
struct Family {
    std::string hash;      ///< the record's attribute family_hash; empty in imports and in older records
    std::string likeness;  ///< hull and main numbers as text: what stands in for the hash where there is none
    std::map<std::string, std::string> settings;  ///< attributes and effects ("effect shifting": "on")
    std::map<std::string, double> numbers;        ///< as solved; none that follow from resolution or machine
};

/// What a grid study (grid-convergence study) keeps of one finished run.
struct GridStudyRun {
    std::string title, method;
    std::filesystem::path file;            ///< its record; empty: none on disk
    double spacing = 0;                    ///< at the hull [m]
    double elements = 0;                   ///< particles or cells [-]
    double element_sizes = 1;              ///< how many sizes of particles it has [-]; 1 where its record tells of none
    double steps = 0;                      ///< of time [-]; 0: not recorded
    double seconds = 0, core_seconds = 0;  ///< everything counted: wall, processor time [s]
    double memory = 0;                     ///< peak [bytes]
    double predicted_seconds = 0;          ///< as said before the run [s]; 0: not said
    double duration = 0;                   ///< simulated [s]
    std::string hull_hash, calibrated;
    Family family;  ///< the same in runs that differ in resolution only
    std::vector<ValidityCheck> failed_checks;
    std::vector<double> domain;  ///< low and high of x, y, z; of x, z in two dimensions [m]
    std::vector<Quantity> quantities;
    std::vector<Reference> references;  ///< what formulas say of them
};
/// Runs of one method with one spacing.
bool same_rung(const GridStudyRun& a, const GridStudyRun& b);
/// Throws InputError: the record has no spacing at the hull.
GridStudyRun grid_study_run(RunRecord record, const CompareOptions& options = {});

/// A run that differs from the grid study's own of the same method and size in one choice that should not matter;
/// `factor` and `steps` as in Varied.
struct GridStudyVariation {
    std::string name;   ///< "sound speed x 1.5"
    double factor = 1;  ///< [-]
    GridStudyRun run;
    double steps = 1;          ///< [-]
    bool box = false;          ///< a wider box: its change counts in all methods, relative to the value
    std::string refused = {};  ///< why it is no evidence; filled by build_grid_study
    std::string input = {};    ///< name of the uncertain number that lies at an end of its interval; empty: a choice
};

/// One method's runs of a grid study, finest first.
struct GridStudySide {
    std::string method;
    std::vector<GridStudyRun> runs;
    std::vector<GridStudyVariation> variations;
    bool similar = true;  ///< false: records without a family hash, and their hulls, speeds or numerics differ
};

/// The change of one quantity in one variation [its unit].
struct Sensitivity {
    std::string name;                               ///< with the method that ran it where that is the other one
    double spacing = 0;                             ///< of the two runs [m]
    double value = 0, varied = 0, uncertainty = 0;  ///< [unit of the quantity]
    bool box = false;
    std::string refused = {};  ///< why it is no evidence and has no uncertainty
    std::string input = {};    ///< of an uncertain number: its name
    /// Equal but for rounding: what was varied does not act in this run, so it is no evidence.
    bool idle() const { return no_more_than_rounding(varied - value, value); }
};

/// One method's finest value S against one from elsewhere D (ASME V&V 20): E = S - D, U_val^2 = U^2 + U_D^2. The
/// verdict is holds() of decide.h: agree and undecided contain D within U_val, differ does not. [unit of the quantity]
struct Validation {
    double E = std::numeric_limits<double>::quiet_NaN(),
           U_val = std::numeric_limits<double>::quiet_NaN();     ///< [unit of the quantity]
    double per_cent = std::numeric_limits<double>::quiet_NaN();  ///< E over |D| [%]
    Verdict verdict = Verdict::not_comparable;
};

/// A value that the methods are held against: measured, or by a formula. It takes no part in the verdict between them.
struct Held {
    std::string source;  ///< "Kleefsman 2005", "Savitsky 1964 (empirical, about ±10 %)"
    MeanValue value;
    std::vector<Validation> validations;  ///< one per side
};

/// What each uncertain number does to a value, by its name: the root of the mean square of the change at either end of its
/// interval (ASME V&V 20-2009, section 4: dS/dX u_X, with a difference in place of the derivative) [unit of the quantity].
/// Not half the difference between the ends: that is 0 of a value that is largest in between.
std::map<std::string, double> inputs_of(const std::vector<Sensitivity>& sensitivities);

/// One quantity of one method in a grid-convergence study.
struct GridStudyValue {
    std::vector<StudyLevel> levels;   ///< the levels whose mean is known, finest first
    std::vector<double> half_widths;  ///< of each level's 95 % interval [unit]; as many as levels
    std::vector<std::string> absent;  ///< why a level is missing, with its spacing
    double statistical = std::numeric_limits<double>::quiet_NaN();  ///< 95 % half width at the finest level [unit]
    Estimate estimate;                                              ///< of the resolution; no levels: nothing known
    std::vector<Sensitivity> sensitivities;
    double choices = 0, box = 0;  ///< roots of the sums of their squares: the box, and all others [unit]
    double input = 0;             ///< root of the sum of the squares of inputs_of [unit]
    double own = std::numeric_limits<double>::quiet_NaN();  ///< of the finest value: all but box and input [unit]
    double uncertainty = std::numeric_limits<double>::quiet_NaN();  ///< of the finest value: all of the above [unit]
    CostOfAccuracy cost, cost_in_cores, cost_in_memory;             ///< against wall time, processor time, memory
};

/// How far one side is from another in one quantity, and what that says.
struct GridStudyDifference {
    std::size_t a = 0, b = 1;  ///< places of the two among the sides
    double size = 0;  ///< reference of per cent and target: mean of the finest values, or the quantity's scale [unit]
    double difference = std::numeric_limits<double>::quiet_NaN();  ///< of the finest values, side b - side a [unit]
    double interval = std::numeric_limits<double>::quiet_NaN();    ///< half width of its 95 % interval [unit]
    double per_cent = std::numeric_limits<double>::quiet_NaN();    ///< difference over the size [%]
    Verdict verdict = Verdict::not_comparable;
    std::string reason = {};
    double seconds_to_target = std::numeric_limits<double>::quiet_NaN();  ///< wall time of runs that decide it [s]
};

/// Its own difference is that of the only two sides, or of the pair that lies farthest apart in units of its interval.
struct GridStudyQuantity : GridStudyDifference {
    std::string name, label, unit;
    std::vector<GridStudyValue> values;      ///< one per side
    std::vector<GridStudyDifference> pairs;  ///< of more than two sides: every pair of them, in their order
    std::vector<Held> held;

    /// Every pair, or the only difference there is.
    std::span<const GridStudyDifference> differences() const {
        return pairs.empty() ? std::span<const GridStudyDifference>(static_cast<const GridStudyDifference*>(this), 1)
                             : pairs;
    }
};

struct GridStudy {
    std::string title;
    std::vector<std::string> left_out;    ///< runs that are missing and why: beyond the budget, failed
    std::vector<std::string> notes;       ///< choices that are no evidence, time steps that do not follow the spacing
    std::vector<std::string> calibrated;  ///< what was chosen by looking at results, as the records say
    std::vector<GridStudySide> sides;
    std::vector<GridStudyQuantity> quantities;
    double agree_within = 0.05;  ///< [-]
};

/// Finished runs of one scene at several sizes, of any number of methods and imports, in any order. The size of a level
/// is its spacing at the hull. For every judged quantity and every two methods a and b, with the finest values S, and of
/// each method the statistics u, the resolution's U_num and the variations' U_var:
///
///   E = S_b - S_a     U^2 = sum over both methods of u^2 + U_num^2 + sum U_var^2
///   S = |S_a + S_b| / 2, at least the quantity's scale
///
/// The box and the uncertain numbers of the scene are in the U of each value and not in that of E: all methods solve the
/// same box with the same numbers, and a shared input cancels.
/// A variation that was to take more time steps counts by those it took (steps.h).
///
/// U_num is that of uncertainty/convergence.h: from three sizes on trend and noise, which knows each size's u as part of
/// the noise. A method without U_num, whose values run away, is not converged, nor is one whose U is no more than
/// rounding; else decide.h: values that scatter have an interval and a verdict like any others.
/// Where undecided, the reason names the largest term and what it would cost to make it small enough. Throws
/// InputError: no run, two runs of one method with one spacing, runs of one method that are of
/// two families, methods with other hulls, a variation without the run that it varies.
///
/// `measured`: records of what was measured (twinwake import), with "uncertainty:TABLE:COLUMN" among their numbers
/// where the measurement has one; what it holds beyond the runs' time takes no part. Throws InputError where one belongs
/// to another hull or another tank.
GridStudy build_grid_study(std::vector<GridStudyRun> runs, std::vector<GridStudyVariation> variations = {},
                           double agree_within = 0.05, const std::vector<RunRecord>& measured = {});

/// Takes those runs out of the list that repeat another one with one choice made otherwise (the sound speed, the time
/// step, the Courant number), as the records' numbers show. Runs without a family hash are left as they are.
std::vector<GridStudyVariation> take_variations(std::vector<GridStudyRun>& runs);

}  // namespace tw

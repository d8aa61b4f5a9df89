#pragma once
#include <string>
#include <vector>

#include "base/numbers.h"
#include "compare/compare.h"

namespace tw {

/// What a sweep varies step by step, and draws curves over.
struct SweptNumber {
    std::string series;  ///< what the member has in common with those that differ from it in this number alone
    double value = nan;  ///< [unit of its axis, see swept_curves.h]
};

/// One scene of a set: what was varied, and what the methods made of it.
struct SweepMember {
    std::string name;                  ///< "prismatic, 8 m/s, 5 deg"
    std::string why_not;               ///< why there is no comparison; empty where there is one
    std::string report;                ///< path of its own report, relative to the sweep's
    std::vector<std::string> methods;  ///< names of its sources
    std::vector<Quantity> quantities;  ///< of its comparison
    std::vector<Reference> references = {};  ///< formulas and measurements of these
    std::string discretisation_from;   ///< as its comparison says; empty: not estimated
    SweptNumber speed = {}, wave_length = {};  ///< of the stream [m/s], of a regular wave [m]
};

/// How two methods stand to each other over a set of scenes, for one quantity:
///
///   r_i = ln(B_i / A_i)     bias = mean r     scatter = standard deviation of r
///   interval = t_95(n-1) scatter/sqrt(n)
///
/// in logarithms, so that a factor of two up and one down cancel. Members where a value is missing or 0, or where the
/// signs differ, are left out and counted.
struct SweepSummary {
    std::string name, label, unit;
    std::size_t a = 0, b = 1;  ///< places of the two among the sweep's methods
    struct Point {
        std::size_t member;
        double a, b;    ///< values of the two methods [unit]
        double Ua, Ub;  ///< half widths of their 95 % intervals [unit]
        double U;       ///< of the interval of b - a [unit]
        Verdict verdict;
    };
    std::vector<Point> points;
    std::size_t left_out = 0;
    double bias = nan, scatter = nan, interval = nan;  ///< logarithms [-]; scatter and interval need two points
};

struct Sweep {
    std::string title;
    std::vector<std::string> methods;
    std::vector<SweepMember> members;
    std::vector<SweepSummary> summaries;  ///< of every judged quantity that some member has, and every two methods
};
/// Members in any order, failed ones among them; those of one method, or of others than the first, are treated as failed.
/// Throws InputError: no member.
Sweep build_sweep(std::string title, std::vector<SweepMember> members);

/// A logarithm of a ratio as people say it: "−8.3 %"; beyond a factor of ten "× 23"; "–" when not finite.
std::string ratio_text(double logarithm);
std::string sweep_text(const Sweep& sweep);  ///< markdown
std::string sweep_json(const Sweep& sweep);
std::string sweep_csv(const Sweep& sweep);   ///< one row per member and quantity
std::string sweep_html(const Sweep& sweep);  ///< a page of its own

}  // namespace tw

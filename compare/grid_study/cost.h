#pragma once
#include <string>
#include <vector>

#include "base/numbers.h"

namespace tw {

/// The cost of one run of a grid-convergence study, and the uncertainty of its value.
struct CostPoint {
    double spacing = 0;                   ///< [m]
    double seconds = 0;                   ///< wall time, meshing and particle generation counted [s]
    double uncertainty = 0;               ///< of the level's value: resolution and statistics [unit of the value]
    double core_seconds = 0, memory = 0;  ///< processor time [s], peak [bytes]
};

/// How the error of one quantity falls with the time that is spent on it: a straight line through the levels in
/// logarithms (least squares),
///
///   U(T) = U_fit (T / T_fit)^-slope
///
/// For a scheme of order p whose cost grows with h^-q the slope is p/q: 2/4 for an explicit method of second order in
/// three dimensions. Where U does not fall with T there is no line: more time has bought nothing.
struct CostOfAccuracy {
    std::vector<CostPoint> points;    ///< finest first
    double slope = nan;               ///< [-]; above 0 where there is a line
    double U_fit = nan, T_fit = nan;  ///< one point of the line: geometric means of the levels [unit], [s]
    std::string why_not;              ///< why there is no line; empty where there is one

    bool known() const { return why_not.empty(); }
    double uncertainty_after(double seconds) const;  ///< on the line; nan where there is none
    double seconds_for(double uncertainty) const;    ///< on the line; nan where there is none
    bool measured(double seconds) const;             ///< lies within the times of the levels
    double price_of_halving() const;                 ///< factor in time that halves U: 2^(1/slope); nan without line
};
CostOfAccuracy cost_of_accuracy(std::vector<CostPoint> points);
/// The same with another price in place of wall time: `seconds` of its points, and of what it answers, is that price.
CostOfAccuracy cost_of_accuracy(std::vector<CostPoint> points, double CostPoint::*price);

/// Where two lines cross [s], U the same: beyond it the steeper one is the cheaper; nan: no line, or parallel.
double crossover_seconds(const CostOfAccuracy& a, const CostOfAccuracy& b);

}  // namespace tw

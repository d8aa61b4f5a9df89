#include "compare/grid_study/cost.h"

#include <algorithm>
#include <cmath>

namespace tw {

CostOfAccuracy cost_of_accuracy(std::vector<CostPoint> points) {
    CostOfAccuracy c;
    std::erase_if(points, [](const CostPoint& p) {
        return !(p.seconds > 0) || !(p.uncertainty > 0) || !std::isfinite(p.uncertainty);
    });
    c.points = std::move(points);
    if (c.points.size() < 2) {
        c.why_not = "needs an uncertainty at two sizes or more";
        return c;
    }
    const double n = static_cast<double>(c.points.size());
    double t = 0, u = 0, tt = 0, tu = 0;
    for (const CostPoint& p : c.points) t += std::log(p.seconds) / n, u += std::log(p.uncertainty) / n;
    for (const CostPoint& p : c.points) {
        const double dt = std::log(p.seconds) - t;
        tt += dt * dt;
        tu += dt * (std::log(p.uncertainty) - u);
    }
    if (!(tt > 0) || !(tu < 0)) {
        c.why_not = "more time has bought no accuracy";
        return c;
    }
    c.slope = -tu / tt;
    c.U_fit = std::exp(u);
    c.T_fit = std::exp(t);
    return c;
}

CostOfAccuracy cost_of_accuracy(std::vector<CostPoint> points, double CostPoint::*price) {
    for (CostPoint& p : points) p.seconds = p.*price;
    return cost_of_accuracy(std::move(points));
}

double CostOfAccuracy::uncertainty_after(double seconds) const { return U_fit * std::pow(seconds / T_fit, -slope); }

double CostOfAccuracy::seconds_for(double uncertainty) const {
    return T_fit * std::pow(U_fit / uncertainty, 1 / slope);
}

bool CostOfAccuracy::measured(double seconds) const {
    const auto [low, high] = std::ranges::minmax(points, {}, &CostPoint::seconds);
    return seconds >= low.seconds && seconds <= high.seconds;
}

double CostOfAccuracy::price_of_halving() const { return std::exp2(1 / slope); }

double crossover_seconds(const CostOfAccuracy& a, const CostOfAccuracy& b) {
    const double by = a.slope - b.slope;
    if (!a.known() || !b.known() || !(std::abs(by) > 1e-3)) return nan;
    // ln U_a - slope_a (ln T - ln T_a) = ln U_b - slope_b (ln T - ln T_b)
    return std::exp((std::log(a.U_fit / b.U_fit) + a.slope * std::log(a.T_fit) - b.slope * std::log(b.T_fit)) / by);
}

}  // namespace tw

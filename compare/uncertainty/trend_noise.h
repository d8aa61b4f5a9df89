#pragma once
#include <span>
#include <string>
#include <vector>

#include "base/numbers.h"
#include "compare/uncertainty/study_level.h"

namespace tw {

/// Trend and noise: values that scatter from size to size as well as they converge. With x_i = h_i/h_1,
///
///   phi_i = phi0 + sum_k a_k x_i^p_k + e_i,      e_i normal with variance sigma^2 / w_i,   w_i = n (1/h_i)/sum(1/h_j)
///
/// for four sets of orders p_k: none (no trend), {1}, {q} and {1, q} (four levels on), q = max(2, order of the scheme).
/// The weights are those of Eca & Hoekstra 2014 (doi:10.1016/j.jcp.2014.01.006), the expansions theirs with free order
/// left out: a free order fits scatter. Each set is one weighted least-squares fit; phi0 given the set is a Student t
///
///   phi0 ~ m + s sqrt((X^T W X + L)^-1_00) t_nu      nu = nu0 + n - n_par      s^2 = (nu0 s0^2 + RSS)/nu
///
/// (conjugate prior of the variance: nu0 = 1 degree of freedom at s0 = Dphi/4, Dphi = (phi_max - phi_min)/(n - 1); it
/// keeps three levels that happen to lie on a line from being certain), s no smaller than the known noise of the
/// values. m is the fit with L = diag(0, s^2/a0^2, ...), the prior of the coefficients: normal about 0 with the standard
/// deviation a0 = 2 (phi_max - phi_min). Without it the set {1, q} explains scatter within the sizes by two large terms
/// that cancel there, and their extrapolation widens the interval several times. The sets are averaged (Hoeting et al., Stat. Sci. 14 (1999) 382) with the weights
///
///   (nu0 s0^2 + RSS)^(-(nu0 + n - 1)/2) n^-(number of a_k)
///
/// and U is the half width about phi_i that holds phi0 with 95 % probability. nu0, s0, a0 and the penalty n^-1 of a
/// coefficient (Schwarz's is n^-1/2) were chosen by the coverage of docs/results/coverage.md.
struct TrendNoise {
    bool known = false;
    std::string why_not;         ///< empty where known
    double trend = nan;          ///< probability that the values have a trend: 1 - weight of the set without one [-]
    double sigma = nan;          ///< standard deviation of the noise, of a level with w = 1 [unit of the value]
    double phi0 = nan;           ///< value at h = 0: mean over the sets [unit of the value]
    double phi0_interval = nan;  ///< half width of its 95 % interval [unit of the value]
    double phi1 = nan;           ///< value at h_1 without its noise: mean over the sets [unit of the value]
    double phi1_interval = nan;  ///< half width of its 95 % interval [unit of the value]
    double uncertainty = nan;    ///< U of the finest value: |phi_1 - phi0| is below it with 95 % [unit of the value]
    /// U of every level, finest first: U_1 in the proportion of sqrt(sigma^2 + (fit at h_i - phi0)^2), the error that the
    /// model expects of a value with that spacing [unit of the value].
    std::vector<double> uncertainties;  ///< [unit of the value]
};

/// `levels`: as from finest_first; fewer than three: not known. `p_th` > 0: the order of the scheme [-].
TrendNoise trend_noise(std::span<const StudyLevel> levels, double p_th);

}  // namespace tw

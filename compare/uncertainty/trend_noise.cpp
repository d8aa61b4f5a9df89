#include "compare/uncertainty/trend_noise.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Dense>

#include "statistics/student_t.h"

namespace tw {

namespace {

constexpr double nu0 = 1;          ///< degrees of freedom of the noise's prior [-]
constexpr double s0_share = 0.25;  ///< its scale over Dphi [-]
constexpr double a_share = 2;      ///< standard deviation of a coefficient's prior over the range of the values [-]
constexpr double probability = 0.95;

struct LevelColumns {
    Eigen::VectorXd x;          ///< h_i/h_1
    Eigen::VectorXd y;          ///< phi_i - phi_1
    Eigen::VectorXd w;          ///< E&H's weights, mean 1
    double s0 = 0;              ///< scale of the noise's prior
    double a0 = 0;              ///< standard deviation of a coefficient's prior
    double known_variance = 0;  ///< of the values' own noise, weighted mean
};

/// One quantity's distribution under one fit: place + scale t_nu.
struct Student {
    double place = 0, scale = 0;
};

struct LineFit {
    double nu = 0, s = 0, log_weight = 0, weight = 0;
    Student at_zero, at_finest;
    Eigen::VectorXd fitted;
};

LineFit fit(const LevelColumns& d, std::span<const double> orders) {
    const Eigen::Index n = d.x.size(), n_par = 1 + static_cast<Eigen::Index>(orders.size());
    Eigen::MatrixXd X = Eigen::MatrixXd::Ones(n, n_par);
    for (Eigen::Index k = 1; k < n_par; ++k) X.col(k) = d.x.array().pow(orders[static_cast<std::size_t>(k - 1)]);
    Eigen::MatrixXd A = X.transpose() * d.w.asDiagonal() * X;
    const Eigen::VectorXd b = X.transpose() * d.w.cwiseProduct(d.y);
    const double RSS = d.w.dot((d.y - X * A.inverse() * b).cwiseAbs2()), prior = nu0 * d.s0 * d.s0;
    LineFit f;
    f.nu = nu0 + static_cast<double>(n - n_par);
    f.s = std::sqrt(std::max((prior + RSS) / f.nu, d.known_variance));
    for (Eigen::Index k = 1; k < n_par; ++k) A(k, k) += f.s * f.s / (d.a0 * d.a0);
    const Eigen::MatrixXd C = A.inverse();
    const Eigen::VectorXd c = C * b;
    f.fitted = X * c;
    const Eigen::VectorXd finest = X.row(0).transpose();
    f.at_zero = {c[0], f.s * std::sqrt(C(0, 0))};
    f.at_finest = {f.fitted[0], f.s * std::sqrt(finest.dot(C * finest))};
    f.log_weight = -0.5 * (nu0 + static_cast<double>(n - 1)) * std::log(prior + RSS) -
                   static_cast<double>(orders.size()) * std::log(static_cast<double>(n));
    return f;
}

double mean_of(const std::vector<LineFit>& fits, Student LineFit::*quantity) {
    double mean = 0;
    for (const LineFit& f : fits) mean += f.weight * (f.*quantity).place;
    return mean;
}

/// The half width about `centre` that holds the quantity with 95 % probability over all fits.
double half_width(const std::vector<LineFit>& fits, Student LineFit::*quantity, double centre) {
    const auto inside = [&](double U) {
        double p = 0;
        for (const LineFit& f : fits) {
            const Student& q = f.*quantity;
            p += f.weight * (student_t_cdf((centre + U - q.place) / q.scale, f.nu) -
                             student_t_cdf((centre - U - q.place) / q.scale, f.nu));
        }
        return p;
    };
    double low = 0, high = 0;
    for (const LineFit& f : fits) high = std::max({high, (f.*quantity).scale, std::abs((f.*quantity).place - centre)});
    while (inside(high) < probability) high *= 2;
    while (high - low > 1e-9 * high) {
        const double middle = 0.5 * (low + high);
        (inside(middle) < probability ? low : high) = middle;
    }
    return high;
}

LevelColumns data_of(std::span<const StudyLevel> levels) {
    const auto n = static_cast<Eigen::Index>(levels.size());
    LevelColumns d{Eigen::VectorXd(n), Eigen::VectorXd(n), Eigen::VectorXd(n)};
    for (Eigen::Index i = 0; i < n; ++i) {
        const StudyLevel& l = levels[static_cast<std::size_t>(i)];
        d.x[i] = l.h / levels[0].h;
        d.y[i] = l.value - levels[0].value;
        d.w[i] = 1 / d.x[i];
    }
    d.w *= static_cast<double>(n) / d.w.sum();
    const double range = d.y.maxCoeff() - d.y.minCoeff();
    d.s0 = s0_share * range / static_cast<double>(n - 1);
    d.a0 = a_share * range;
    for (Eigen::Index i = 0; i < n; ++i) {
        const StudyLevel& l = levels[static_cast<std::size_t>(i)];
        const double u = std::hypot(l.half_width / 1.96, l.rounding / std::sqrt(3.0));  // standard error of the value
        d.known_variance += d.w[i] * u * u / static_cast<double>(n);
    }
    return d;
}

}  // namespace

TrendNoise trend_noise(std::span<const StudyLevel> levels, double p_th) {
    TrendNoise t;
    if (levels.size() < 3) {
        t.why_not = "needs three sizes";
        return t;
    }
    t.known = true;
    const auto [low, high] = std::ranges::minmax(levels, {}, &StudyLevel::value);
    if (same_but_for_rounding(low, high, largest_magnitude(levels))) {
        t.trend = t.sigma = t.phi0_interval = t.phi1_interval = 0;
        t.phi0 = t.phi1 = levels[0].value;
        t.uncertainty = high.value - low.value;
        t.uncertainties.assign(levels.size(), t.uncertainty);
        return t;
    }
    const LevelColumns d = data_of(levels);
    const double q = std::max(2.0, p_th);
    std::vector<std::vector<double>> sets{{}, {1}, {q}};
    if (levels.size() > 3) sets.push_back({1, q});
    std::vector<LineFit> fits;
    for (const std::vector<double>& orders : sets) fits.push_back(fit(d, orders));
    const double best = std::ranges::max(fits, {}, &LineFit::log_weight).log_weight;
    double sum = 0, variance = 0;
    for (LineFit& f : fits) sum += f.weight = std::exp(f.log_weight - best);
    for (LineFit& f : fits) variance += (f.weight /= sum) * f.s * f.s;

    t.trend = 1 - fits.front().weight;
    t.sigma = std::sqrt(variance);
    const double zero = mean_of(fits, &LineFit::at_zero), finest = mean_of(fits, &LineFit::at_finest);
    t.phi0 = levels[0].value + zero;
    t.phi1 = levels[0].value + finest;
    t.phi0_interval = half_width(fits, &LineFit::at_zero, zero);
    t.phi1_interval = half_width(fits, &LineFit::at_finest, finest);
    t.uncertainty = half_width(fits, &LineFit::at_zero, 0);
    Eigen::VectorXd squares = Eigen::VectorXd::Constant(d.x.size(), variance);
    for (const LineFit& f : fits) squares += f.weight * (f.fitted.array() - f.at_zero.place).square().matrix();
    for (const double square : squares) t.uncertainties.push_back(t.uncertainty * std::sqrt(square / squares[0]));
    return t;
}

}  // namespace tw

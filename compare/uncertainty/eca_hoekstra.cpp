#include "compare/uncertainty/eca_hoekstra.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Dense>

#include "compare/uncertainty/triplet.h"

namespace tw {

namespace {

constexpr double smallest_p = 0.5, largest_p = 2;  // range in which the free fit is trusted
constexpr double search_to = 10;                   // |p| of the free fit is looked for up to here
constexpr double rounding_of_p = 1e-6;             // so that exact h^2 and h^0.5 count as inside

struct Fit {
    ErrorFit form = ErrorFit::free_order;
    bool weighted = false;
    double p = 0, phi0 = 0, sigma = 0;
    Eigen::VectorXd fitted;
};

struct Data {
    Eigen::VectorXd x;    // h_i/h_1: the fits do not depend on the unit of h
    Eigen::VectorXd phi;  // phi_i
    Eigen::VectorXd n_w;  // n_g w_i
};

/// Least squares for phi = c0 + sum c_k column_k; sigma and `fitted` are set, the coefficients returned.
Eigen::VectorXd solve(const Data& d, const Eigen::MatrixXd& columns, Eigen::Index parameters, Fit& fit) {
    Eigen::MatrixXd A(d.x.size(), columns.cols() + 1);
    A << Eigen::VectorXd::Ones(d.x.size()), columns;
    const Eigen::VectorXd root = d.n_w.cwiseSqrt();
    // The mean is taken off first: small changes of a large value keep their digits.
    const double mean = d.phi.mean();
    const Eigen::VectorXd phi = d.phi.array() - mean;
    Eigen::VectorXd c = (root.asDiagonal() * A).colPivHouseholderQr().solve(root.cwiseProduct(phi));
    const Eigen::VectorXd r = phi - A * c;
    fit.sigma = std::sqrt(d.n_w.dot(r.cwiseAbs2()) / static_cast<double>(d.x.size() - parameters));
    fit.fitted = d.phi - r;
    c[0] += mean;
    return c;
}

/// phi = phi0 + alpha x^p for a given p, written phi1_fit + b (x^p - 1)/p, which stays good through p = 0.
Fit fit_with(const Data& d, double p) {
    Fit f;
    f.p = p;
    const Eigen::VectorXd growth = d.x.unaryExpr([p](double x) {
        const double ln_x = std::log(x);
        return std::abs(p * ln_x) < 1e-12 ? ln_x : std::expm1(p * ln_x) / p;
    });
    const Eigen::VectorXd c = solve(d, growth, 3, f);
    f.phi0 = c[0] - c[1] / p;
    return f;
}

/// phi = phi0 + alpha h^p with p free: the best of a scan over p, then golden section between its neighbours.
Fit free_fit(const Data& d) {
    constexpr int steps = 400;
    const auto sigma = [&](double p) { return fit_with(d, p).sigma; };
    const auto p_of = [](int k) { return search_to * (2.0 * k / steps - 1); };
    int best = 0;
    double best_sigma = sigma(p_of(0));
    for (int k = 1; k <= steps; ++k)
        if (const double s = sigma(p_of(k)); s < best_sigma) best = k, best_sigma = s;
    double low = p_of(std::max(best - 1, 0)), high = p_of(std::min(best + 1, steps));
    const double golden = 0.5 * (std::sqrt(5.0) - 1);
    while (high - low > 1e-11) {
        const double left = high - golden * (high - low), right = low + golden * (high - low);
        if (sigma(left) < sigma(right))
            high = right;
        else
            low = left;
    }
    return fit_with(d, 0.5 * (low + high));
}

Fit polynomial_fit(const Data& d, ErrorFit form) {
    Fit f;
    f.form = form;
    const bool both = form == ErrorFit::first_and_second;
    Eigen::MatrixXd columns(d.x.size(), both ? 2 : 1);
    columns.col(0) = form == ErrorFit::second ? Eigen::VectorXd(d.x.cwiseAbs2()) : d.x;
    if (both) columns.col(1) = d.x.cwiseAbs2();
    f.phi0 = solve(d, columns, both ? 3 : 2, f)[0];
    return f;
}

/// Every change from level to level is against the one before.
bool alternates(std::span<const StudyLevel> levels) {
    for (std::size_t i = 2; i < levels.size(); ++i)
        if ((levels[i].value - levels[i - 1].value) * (levels[i - 1].value - levels[i - 2].value) >= 0) return false;
    return true;
}

bool trusted(const Fit& f) { return f.p >= smallest_p - rounding_of_p && f.p <= largest_p + rounding_of_p; }

}  // namespace

std::string to_string(ErrorFit fit) {
    switch (fit) {
        case ErrorFit::free_order: return "phi0 + alpha h^p";
        case ErrorFit::first: return "phi0 + alpha h";
        case ErrorFit::second: return "phi0 + alpha h^2";
        case ErrorFit::first_and_second: return "phi0 + alpha1 h + alpha2 h^2";
    }
    return {};
}

EcaHoekstra eca_hoekstra(std::span<const StudyLevel> levels) {
    EcaHoekstra e;
    if (levels.size() < 4) {
        e.why_not = "needs four sizes";
        return e;
    }
    const auto n_g = static_cast<Eigen::Index>(levels.size());
    Data plain{Eigen::VectorXd(n_g), Eigen::VectorXd(n_g), Eigen::VectorXd::Ones(n_g)};
    for (Eigen::Index i = 0; i < n_g; ++i) {
        const StudyLevel& l = levels[static_cast<std::size_t>(i)];
        plain.x[i] = l.h / levels[0].h;
        plain.phi[i] = l.value;
    }
    Data weighted = plain;
    const double sum = plain.x.cwiseInverse().sum();
    weighted.n_w = static_cast<double>(n_g) * plain.x.cwiseInverse() / sum;

    const double phi_max = plain.phi.maxCoeff(), phi_min = plain.phi.minCoeff();
    e.data_range = (phi_max - phi_min) / static_cast<double>(n_g - 1);
    const auto [lowest, highest] = std::ranges::minmax(levels, {}, &StudyLevel::value);
    if (same_but_for_rounding(lowest, highest, largest_magnitude(levels))) {
        e.known = true;
        e.convergence = Convergence::unchanged;
        e.phi0 = levels[0].value;
        e.sigma = 0;
        e.uncertainty = phi_max - phi_min;
        e.uncertainties.assign(levels.size(), e.uncertainty);
        return e;
    }

    const auto smaller_sigma = [](const Fit& a, const Fit& b) { return a.sigma < b.sigma; };
    std::vector<Fit> fits;
    const auto add = [&](const Data& d, bool with_weights, auto fit) {
        fits.push_back(fit(d));
        fits.back().weighted = with_weights;
    };
    const auto add_both = [&](auto fit) { add(plain, false, fit), add(weighted, true, fit); };

    add_both(free_fit);
    e.p = std::ranges::min_element(fits, smaller_sigma)->p;
    if (std::ranges::any_of(fits, trusted)) {
        std::erase_if(fits, [](const Fit& f) { return !trusted(f); });
    } else {
        fits.clear();
        for (const ErrorFit form : {ErrorFit::first, ErrorFit::second, ErrorFit::first_and_second})
            if (form != ErrorFit::first_and_second || e.p < smallest_p)
                add_both([form](const Data& d) { return polynomial_fit(d, form); });
    }
    const Fit& best = *std::ranges::min_element(fits, smaller_sigma);
    if (best.form == ErrorFit::free_order) e.p = best.p;
    e.fit = best.form;
    e.weighted = best.weighted;
    e.phi0 = best.phi0;
    e.sigma = best.sigma;
    e.fitted.assign(best.fitted.begin(), best.fitted.end());

    const bool scattered = e.sigma >= e.data_range;
    e.convergence = scattered              ? Convergence::scattered
                    : alternates(levels)   ? finest_triplet(levels).convergence
                    : e.p <= rounding_of_p ? Convergence::divergent
                                           : Convergence::monotone;
    const bool p_in_range = e.p >= smallest_p - rounding_of_p && e.p < 2.1;
    if (std::abs(e.p) > 0.999 * search_to) e.p = nan;
    if (e.convergence == Convergence::divergent) {
        e.phi0 = nan;
        e.why_not = "the changes do not decrease as the spacing shrinks";
        return e;
    }
    e.known = true;
    e.Fs = scattered ? 3 * e.sigma / e.data_range : p_in_range ? 1.25 : 3;
    for (Eigen::Index i = 0; i < n_g; ++i) {
        const double eps = std::abs(plain.phi[i] - e.phi0), rest = e.sigma + std::abs(plain.phi[i] - best.fitted[i]);
        e.uncertainties.push_back(scattered ? e.Fs * (eps + rest) : e.Fs * eps + rest);
    }
    e.uncertainty = e.uncertainties.front();
    return e;
}

}  // namespace tw

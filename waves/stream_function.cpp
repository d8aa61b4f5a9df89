#include "waves/stream_function.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Dense>
#include <numbers>
#include <optional>
#include <stdexcept>

namespace tw {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;

/// The equations of one wave with n terms. Unknowns: eta_0 ... eta_n at x = m pi / n, then
/// b_j = B_j exp(j H/2) (B_j itself falls by orders of magnitude from term to term), c, q - c d, r.
class WaveEquations {
public:
    WaveEquations(double depth, int n) : d_(depth), n_(n), cos_(n + 1, n), sin_(n + 1, n) {
        for (int m = 0; m <= n; ++m)
            for (int j = 1; j <= n; ++j) {
                const double angle = pi * (static_cast<long>(m) * j % (2 * n)) / n;
                cos_(m, j - 1) = std::cos(angle);
                sin_(m, j - 1) = std::sin(angle);
            }
    }
    int unknowns() const { return 2 * n_ + 4; }
    int b(int j) const { return n_ + j; }  // j from 1
    int c() const { return 2 * n_ + 1; }
    int q() const { return 2 * n_ + 2; }
    int r() const { return 2 * n_ + 3; }

    VectorXd linear(double height) const {
        VectorXd x = VectorXd::Zero(unknowns());
        for (int m = 0; m <= n_; ++m) x(m) = height / 2 * std::cos(m * pi / n_);
        x(c()) = std::sqrt(std::tanh(d_));
        x(b(1)) = height / 2 / x(c()) * std::exp(-height / 2);
        x(r()) = x(c()) * x(c()) / 2;
        return x;
    }

    /// From a solution with fewer terms.
    VectorXd from(const SteadyWave& w) const {
        VectorXd x = VectorXd::Zero(unknowns());
        for (std::size_t j = 1; j <= w.B.size(); ++j) {
            x(b(static_cast<int>(j))) = w.B[j - 1] * std::exp(static_cast<double>(j) * w.height / 2);
            for (int m = 0; m <= n_; ++m) x(m) += w.E[j - 1] * std::cos(static_cast<double>(j) * m * pi / n_);
        }
        x(c()) = w.speed;
        x(q()) = -w.flux;
        x(r()) = w.bernoulli;
        return x;
    }

    /// Newton's steps from x; none where they do not settle.
    std::optional<VectorXd> solved(VectorXd x, double height) const {
        VectorXd f(unknowns());
        MatrixXd jacobian(unknowns(), unknowns());
        for (int step = 0; step < 20; ++step) {
            evaluate(x, height, f, jacobian);
            if (!f.allFinite() || !jacobian.allFinite()) return {};
            const VectorXd dx = jacobian.partialPivLu().solve(-f);
            x += dx;
            const double size = dx.cwiseAbs().maxCoeff();
            if (!(size < 10)) return {};  // or no number
            if (size < 1e-11) return is_a_wave(x) ? std::optional(x) : std::nullopt;
        }
        return {};
    }

    SteadyWave measured(const VectorXd& x, double height) const {
        SteadyWave w;
        w.depth = d_;
        w.height = height;
        for (int j = 1; j <= n_; ++j) {
            w.B.push_back(x(b(j)) * std::exp(-j * height / 2));
            double e = 0;
            for (int m = 0; m <= n_; ++m) e += weight(m) * x(m) * cos_(m, j - 1);
            w.E.push_back((j == n_ ? 1 : 2) * e / n_);
        }
        w.crest = x(0);
        w.trough = x(n_);
        w.speed = x(c());
        w.flux = -x(q());
        w.bernoulli = x(r());
        return w;
    }

private:
    double weight(int m) const { return m == 0 || m == n_ ? 0.5 : 1; }  // trapezoidal rule

    /// Falling from crest to trough: other solutions have more crests in the wave length.
    bool is_a_wave(const VectorXd& x) const {
        for (int m = 0; m < n_; ++m)
            if (!(x(m) > x(m + 1) - 1e-9)) return false;
        return x(c()) > 0;
    }

    void evaluate(const VectorXd& x, double height, VectorXd& f, MatrixXd& jacobian) const {
        jacobian.setZero();
        double mean = 0;
        for (int m = 0; m <= n_; ++m) {
            const double eta = x(m);
            double psi = -x(c()) * eta + x(q()), u = -x(c()), w = 0, u_z = 0, w_z = 0;
            const int flow = m, pressure = n_ + 1 + m;
            for (int j = 1; j <= n_; ++j) {
                // sinh and cosh of j (z + d) over cosh j d, times exp(-j H/2)
                const double up = std::exp(j * (eta - height / 2)), down = std::exp(-j * (eta + 2 * d_ + height / 2)),
                             of_depth = 1 + std::exp(-2 * j * d_), S = (up - down) / of_depth,
                             C = (up + down) / of_depth, cs = cos_(m, j - 1), sn = sin_(m, j - 1), B = x(b(j));
                psi += B * S * cs;
                u += j * B * C * cs;
                w += j * B * S * sn;
                u_z += j * j * B * S * cs;
                w_z += j * j * B * C * sn;
                jacobian(flow, b(j)) = S * cs;
            }
            for (int j = 1; j <= n_; ++j) {
                const double up = std::exp(j * (eta - height / 2)), down = std::exp(-j * (eta + 2 * d_ + height / 2)),
                             of_depth = 1 + std::exp(-2 * j * d_);
                jacobian(pressure, b(j)) =
                    j * (u * (up + down) * cos_(m, j - 1) + w * (up - down) * sin_(m, j - 1)) / of_depth;
            }
            f(flow) = psi;
            jacobian(flow, m) = u;
            jacobian(flow, c()) = -eta;
            jacobian(flow, q()) = 1;
            f(pressure) = (u * u + w * w) / 2 + eta - x(r());
            jacobian(pressure, m) = u * u_z + w * w_z + 1;
            jacobian(pressure, c()) = -u;
            jacobian(pressure, r()) = -1;
            mean += weight(m) * eta / n_;
            jacobian(2 * n_ + 3, m) = weight(m) / n_;
        }
        f(2 * n_ + 2) = x(0) - x(n_) - height;
        jacobian(2 * n_ + 2, 0) = 1;
        jacobian(2 * n_ + 2, n_) = -1;
        f(2 * n_ + 3) = mean;
    }

    double d_;
    int n_;
    MatrixXd cos_, sin_;
};

/// How much the last eighth of the terms matters, to the flow at the crest or to the surface, over the height.
double tail(const SteadyWave& w) {
    double most = 0;
    const std::size_t n = w.B.size();
    for (std::size_t j = n - n / 8; j <= n; ++j)
        most =
            std::max({most, std::abs(w.B[j - 1]) * std::exp(static_cast<double>(j) * w.crest), std::abs(w.E[j - 1])});
    return most / w.height;
}

/// From small heights on, each step begun from the line through the last two solutions; steps that fail are halved.
std::optional<VectorXd> continued(const WaveEquations& of, double depth, double height) {
    const double small = std::min({height, 0.05, 0.05 * depth * depth * depth});
    std::optional<VectorXd> last = of.solved(of.linear(small), small);
    if (!last) return {};
    if (small == height) return last;
    double at = small, before = 0, step = small;
    VectorXd earlier;
    for (int attempt = 0; at < height; ++attempt) {
        if (attempt == 40) return {};
        const double next = std::min(height, at + step);
        VectorXd guess = *last;
        if (earlier.size() > 0) guess += (*last - earlier) * ((next - at) / (at - before));
        if (auto found = of.solved(std::move(guess), next)) {
            earlier = *last;
            before = at;
            last = std::move(found);
            at = next;
            step *= 2;
        } else if ((step = (next - at) / 2) < 2e-3 * height) {
            return {};
        }
    }
    return last;
}

}  // namespace

SteadyWave steady_wave(double k_depth, double k_height) {
    if (!(k_depth > 0) || !(k_height > 0)) throw std::domain_error("a steady wave needs a depth and a height");
    const double depth = std::min(k_depth, 25.0);
    SteadyWave best;
    for (const int n : {12, 20, 28, 40, 56, 76, 96}) {
        if (n * depth < 3) continue;  // the crest of a long wave is a few depths wide
        const WaveEquations equations(depth, n);
        const bool is_first = best.B.empty();
        const auto x =
            is_first ? continued(equations, depth, k_height) : equations.solved(equations.from(best), k_height);
        if (!x && is_first) continue;
        if (!x) break;
        SteadyWave found = equations.measured(*x, k_height);
        if (!is_first && tail(found) > tail(best)) break;  // of what rounding has left
        best = std::move(found);
        if (tail(best) < 1e-9) break;
    }
    if (best.B.empty()) throw std::domain_error("no steady wave of this height was found");
    return best;
}

}  // namespace tw

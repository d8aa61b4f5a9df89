#include "waves/sea.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "waves/dispersion.h"

namespace tw {
namespace {

using std::numbers::pi;

constexpr double lowest = 0.5, highest = 2.5;  ///< of the peak's frequency: where components begin and end

/// Uniform in [0, 1) (Steele, Lea & Flood 2014, splitmix64; the 53 upper bits).
class Uniform {
public:
    explicit Uniform(std::uint64_t seed) : state_(seed) {}
    double next() {
        std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ULL);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
    }

private:
    std::uint64_t state_;
};

/// Of the spectrum's shape, by Simpson's rule.
double integral(double from, double to, double fp, double gamma) {
    constexpr int parts = 32;
    const double h = (to - from) / parts;
    double sum = jonswap_shape(from, fp, gamma) + jonswap_shape(to, fp, gamma);
    for (int i = 1; i < parts; ++i) sum += (i % 2 == 1 ? 4 : 2) * jonswap_shape(from + i * h, fp, gamma);
    return sum * h / 3;
}

void set_frequency(Sea& sea, int n, double omega) {
    sea.waves.omega[n] = omega;
    sea.waves.k[n] = wave_number(omega, sea.gravity, sea.depth());
}

/// Frequencies in the water and as they are met in the scene's axes, omega + direction k stream [rad/s].
class Met {
public:
    explicit Met(const SeaOrder& order) : order_(order) {}
    double operator()(double omega) const {
        return order_.stream == 0
                   ? omega
                   : omega + order_.direction * order_.stream * wave_number(omega, order_.gravity, order_.depth);
    }
    /// In the water, of those up to `most`, below which what is met rises with it.
    double in_water(double met, double most) const {
        if (order_.stream == 0) return met;
        return rises_to([&](double omega) { return (*this)(omega) < met; }, most);
    }
    /// The highest whose energy runs against the stream fast enough, up to `most`.
    double highest_that_passes(double most) const {
        if (order_.stream * order_.direction >= 0) return most;
        return rises_to(
            [&](double omega) {
                const double k = wave_number(omega, order_.gravity, order_.depth);
                return order_.stream < slowest_passing * group_speed_ratio(k * order_.depth) * omega / k;
            },
            most);
    }

private:
    template <class Below>
    static double rises_to(Below below, double most) {
        double low = 0, high = most;
        for (int step = 0; step < 200 && high - low > 1e-15 * most; ++step) {
            const double middle = std::midpoint(low, high);
            (below(middle) ? low : high) = middle;
        }
        return high;
    }
    const SeaOrder& order_;
};

void fill_spectrum(Sea& sea, const SeaOrder& order) {
    const Met met(order);
    const double fp = 1 / order.peak_period, gamma = order.kind == Sea::Kind::pierson_moskowitz ? 1 : order.peakedness,
                 top = order.stream == 0 ? highest * fp : met.highest_that_passes(2 * pi * highest * fp) / (2 * pi),
                 low = met(2 * pi * lowest * fp) / (2 * pi), high = met(2 * pi * top) / (2 * pi),
                 step = (high - low) / order.components;
    const auto in_water = [&](double f) { return met.in_water(2 * pi * f, 1.3 * 2 * pi * top) / (2 * pi); };
    const int first = static_cast<int>(std::ceil(low / step - 1e-9));
    sea.waves.count = order.components;
    sea.repeat_period = 1 / step;
    double all = 0;
    double energy[WaveComponents::most];
    for (int n = 0; n < sea.waves.count; ++n) {
        const double f = (first + n) * step;
        set_frequency(sea, n, 2 * pi * in_water(f));
        energy[n] = integral(in_water(f - step / 2), in_water(f + step / 2), fp, gamma);
        all += energy[n];
    }
    const double begin = in_water((first - 0.5) * step), end = in_water((first + sea.waves.count - 0.5) * step);
    double outside = integral(std::min(0.3 * fp, begin), begin, fp, gamma);
    for (double f = end; f < 40 * fp; f *= 1.25) outside += integral(f, 1.25 * f, fp, gamma);
    sea.beyond = outside / (outside + all);
    const bool focused = order.kind == Sea::Kind::focused;
    Uniform random(order.seed);
    for (int n = 0; n < sea.waves.count; ++n) {
        const double share = energy[n] / all;
        sea.waves.height[n] = focused ? order.height * share : order.height * std::sqrt(share / 8);
        sea.waves.phase[n] = focused
                                 ? sea.met(n) * order.focus_time - sea.waves.k[n] * order.direction * order.focus_place
                                 : 2 * pi * random.next();
    }
}

void fill_two(Sea& sea, const SeaOrder& order) {
    sea.waves.count = 2;
    const int first = order.periods[0] >= order.periods[1] ? 0 : 1;  // lower frequency first
    for (int n = 0; n < 2; ++n) {
        const int from = n == 0 ? first : 1 - first;
        set_frequency(sea, n, 2 * pi / order.periods[from]);
        sea.waves.height[n] = order.heights[from] / 2;
    }
    sea.repeat_period = 2 * pi / (sea.met(1) - sea.met(0));
    sea.peak_period = order.heights[0] >= order.heights[1] ? order.periods[0] : order.periods[1];
}

/// Second-order part of a pair at phases theta_i and theta_j; i = j: of a wave with itself.
struct Pairs {
    const Sea& sea;

    template <class Use>
    void each(Use use) const {
        const WaveComponents& w = sea.waves;
        for (int i = 0; i < w.count; ++i)
            for (int j = i; j < w.count; ++j)
                use(i, j,
                    bound_waves(w.k[i], w.omega[i] * w.omega[i] / sea.gravity, w.k[j],
                                w.omega[j] * w.omega[j] / sea.gravity, w.depth),
                    (i == j ? 0.25 : 0.5) * w.height[i] * w.height[j]);
    }
};

/// eta, to first or to first and second order, at one place: the kernels are the same at all times.
class SurfaceAt {
public:
    SurfaceAt(const Sea& sea, double x, bool second_order) : sea_(sea), x_(x) {
        if (!second_order) return;
        Pairs{sea}.each([&](int i, int j, const BoundWaves& K, double a) {
            const WaveComponents& w = sea.waves;
            const double of_i = w.k[i] * w.direction * x + w.phase[i], of_j = w.k[j] * w.direction * x + w.phase[j];
            bound_.push_back({K.sum * a, sea.met(i) + sea.met(j), of_i + of_j});
            if (i != j) bound_.push_back({K.difference * a, sea.met(i) - sea.met(j), of_i - of_j});
        });
    }
    double operator()(double t) const {
        double eta = wave_surface(sea_.waves, x_, t);
        for (const Line& b : bound_) eta += b.height * std::cos(b.phase - b.omega * t);
        return eta;
    }

private:
    struct Line {
        double height, omega, phase;
    };
    const Sea& sea_;
    double x_;
    std::vector<Line> bound_ = {};
};

}  // namespace

double jonswap_shape(double f, double fp, double gamma) {
    const double r = f / fp, sigma = r <= 1 ? 0.07 : 0.09, off = (r - 1) / sigma;
    return std::pow(r, -5) * std::exp(-1.25 * std::pow(r, -4)) * std::pow(gamma, std::exp(-off * off / 2));
}

Sea make_sea(const SeaOrder& order) {
    Sea sea;
    sea.kind = order.kind;
    sea.gravity = order.gravity;
    sea.waves.depth = order.depth;
    sea.waves.direction = order.direction;
    sea.waves.stream = order.stream;
    sea.peak_period = order.peak_period;
    if (order.kind == Sea::Kind::bichromatic)
        fill_two(sea, order);
    else
        fill_spectrum(sea, order);
    if (order.kind == Sea::Kind::focused) sea.focus_place = order.focus_place, sea.focus_time = order.focus_time;
    sea.significant_height = 4 * std::sqrt(sea.moment(0));
    sea.waves.current = order.stream;
    if (order.stream != 0) return sea;
    double transport = 0;  // between still water and the surface, which a return current cancels
    for (int n = 0; n < sea.waves.count; ++n)
        transport += sea.energy(n) * sea.waves.omega[n] / std::tanh(sea.waves.k[n] * order.depth);
    sea.waves.current = -order.direction * transport / order.depth;
    return sea;
}

double Sea::met(int n) const { return waves.omega[n] + waves.direction * waves.k[n] * waves.stream; }

double Sea::peak_period_met() const {
    const double omega = 2 * pi / peak_period;
    return waves.stream == 0 ? peak_period
                             : 2 * pi / (omega + waves.direction * waves.stream * wave_number(omega, gravity, depth()));
}

double Sea::moment(int order) const {
    double m = 0;
    for (int n = 0; n < waves.count; ++n) m += std::pow(frequency(n), order) * energy(n);
    return m;
}

int Sea::component_at(double share_of_energy) const {
    const double all = moment(0);
    double sum = 0;
    for (int n = 0; n < waves.count; ++n)
        if ((sum += energy(n)) >= share_of_energy * all * (1 - 1e-12)) return n;
    return waves.count - 1;
}

double Sea::length_at_peak() const { return 2 * pi / wave_number(2 * pi / peak_period, gravity, depth()); }

double Sea::pressure_over_density(double x, double z, double t) const {
    double p = 0;
    for (int n = 0; n < waves.count; ++n) {
        const double k = waves.k[n], D = std::exp(-2 * k * depth());
        p += gravity * waves.height[n] * std::exp(k * z) * (1 + std::exp(-2 * k * (z + depth()))) / (1 + D) *
             std::cos(k * waves.direction * x - met(n) * t + waves.phase[n]);
    }
    return p;
}

BoundWaves bound_waves(double k_i, double R_i, double k_j, double R_j, double depth) {
    const double p = std::sqrt(R_i), q = std::sqrt(R_j), a = k_i * k_i - R_i * R_i, b = k_j * k_j - R_j * R_j,
                 both = k_i + k_j, between = std::abs(k_i - k_j);
    const double plus = p + q, minus = p - q;
    const double D_plus = (plus * (p * b + q * a) + 2 * plus * plus * (k_i * k_j - R_i * R_j)) /
                          (plus * plus - both * std::tanh(both * depth));
    BoundWaves K{(D_plus - (k_i * k_j - R_i * R_j)) / (p * q) + R_i + R_j, 0};
    if (between > 0) {
        const double D_minus = (minus * (q * a - p * b) + 2 * minus * minus * (k_i * k_j + R_i * R_j)) /
                               (minus * minus - between * std::tanh(between * depth));
        K.difference = (D_minus - (k_i * k_j + R_i * R_j)) / (p * q) + R_i + R_j;
    }
    return K;
}

double second_order_surface(const Sea& sea, double x, double t) {
    return SurfaceAt(sea, x, true)(t) - wave_surface(sea.waves, x, t);
}

double SecondOrderShare::both() const { return std::hypot(sum, difference); }

SecondOrderShare left_out_by_first_order(const Sea& sea) {
    double sum = 0, difference = 0;  // mean squares
    Pairs{sea}.each([&](int, int, const BoundWaves& K, double a) {
        sum += K.sum * a * K.sum * a / 2;
        difference += K.difference * a * K.difference * a / 2;
    });
    return {4 * std::sqrt(sum) / sea.significant_height, 4 * std::sqrt(difference) / sea.significant_height};
}

Crest highest_crest(const Sea& sea, double x, double from, double to, bool second_order) {
    const SurfaceAt surface(sea, x, second_order);
    const double step = sea.peak_period_met() / 64;
    Crest best{-HUGE_VAL, from};
    for (double t = from; t <= to; t += step)
        if (const double eta = surface(t); eta > best.height) best = {eta, t};
    double low = best.time - step, high = best.time + step;  // narrowed by thirds
    for (int i = 0; i < 60; ++i) {
        const double left = low + (high - low) / 3, right = high - (high - low) / 3;
        (surface(left) < surface(right) ? low : high) = surface(left) < surface(right) ? left : right;
    }
    return {surface(low), low};
}

std::string name_of(Sea::Kind kind) {
    switch (kind) {
        case Sea::Kind::jonswap: return "JONSWAP";
        case Sea::Kind::pierson_moskowitz: return "Pierson-Moskowitz";
        case Sea::Kind::bichromatic: return "bichromatic";
        default: return "focused (NewWave)";
    }
}

}  // namespace tw

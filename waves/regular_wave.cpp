#include "waves/regular_wave.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "waves/dispersion.h"
#include "waves/stream_function.h"

namespace tw {
namespace {

using std::numbers::pi;

RegularWave linear_wave(const WaveOrder& order, double length) {
    RegularWave w;
    w.theory = RegularWave::Theory::linear;
    const double k = 2 * pi / length, omega = wave_frequency(k, order.gravity, order.depth), a = order.height / 2;
    w.crest = a;
    w.trough = -a;
    w.speed_in_water = omega / k;
    w.transport = a * a * omega / (2 * std::tanh(k * order.depth));  // between trough and crest, to second order
    w.bernoulli = w.speed_in_water * w.speed_in_water / 2;
    w.sum.terms = 1;
    w.sum.eta[0] = a;
    w.sum.U[0] = a * omega / -std::expm1(-2 * k * order.depth);  // a omega cosh k(z + d) / sinh kd
    return w;
}

RegularWave fenton_wave(const WaveOrder& order, double length) {
    RegularWave w;
    const double k = 2 * pi / length, g = order.gravity, speed = std::sqrt(g / k);
    const SteadyWave steady = steady_wave(k * order.depth, k * order.height);
    w.crest = steady.crest / k;
    w.trough = steady.trough / k;
    w.speed_in_water = steady.speed * speed;
    w.transport = steady.flux * speed / k;
    w.bernoulli = steady.bernoulli * g / k;
    w.sum.terms = std::min(static_cast<int>(steady.B.size()), WaveSum::most);
    const auto matters = [&](int j) {  // to velocity and surface
        return std::abs(j * steady.B[j - 1]) * std::exp(j * steady.crest) > 1e-12 * steady.speed ||
               std::abs(steady.E[j - 1]) > 1e-12 * steady.height;
    };
    while (w.sum.terms > 1 && !matters(w.sum.terms)) --w.sum.terms;
    for (int j = 1; j <= w.sum.terms; ++j) {
        w.sum.eta[j - 1] = steady.E[j - 1] / k;
        w.sum.U[j - 1] = j * steady.B[j - 1] * speed / (1 + std::exp(-2 * j * k * order.depth));
    }
    return w;
}

/// The wave of a length by one theory, with what does not depend on it.
RegularWave of_length(const WaveOrder& order, RegularWave::Theory theory, double length) {
    RegularWave w = theory == RegularWave::Theory::linear ? linear_wave(order, length) : fenton_wave(order, length);
    w.height = order.height;
    w.length = length;
    w.depth = order.depth;
    w.gravity = order.gravity;
    w.sum.k = 2 * pi / length;
    w.sum.depth = order.depth;
    w.sum.direction = order.direction;
    w.sum.across = order.across;
    w.sum.crest = w.crest;
    w.sum.current = order.closed ? -order.direction * w.transport / order.depth : order.stream;
    w.sum.speed = w.speed_in_water + order.direction * w.sum.current;
    return w;
}

/// The length that has the period asked for: secant steps in the logarithm of the length from that of linear theory.
/// The speed grows slower than the length, so T = L / c grows with it.
RegularWave of_period(const WaveOrder& order, RegularWave::Theory theory) {
    const auto period = [&](const RegularWave& w) { return order.closed ? w.encounter_period() : w.period_in_water(); };
    double length = 2 * pi / wave_number(2 * pi / *order.period, order.gravity, order.depth);
    RegularWave wave = of_length(order, theory, length);
    double slope = 1.5;  // d log L / d log T, from 2 in deep to 1 in shallow water
    for (int step = 0; step < 40; ++step) {
        const double off = std::log(*order.period / period(wave));
        if (std::abs(off) < 1e-12) return wave;
        const double before = length;
        length *= std::exp(slope * off);
        wave = of_length(order, theory, length);
        const double moved = off - std::log(*order.period / period(wave));
        if (moved != 0) slope = std::clamp(std::log(length / before) / moved, 0.5, 3.0);
    }
    if (std::abs(std::log(*order.period / period(wave))) < 1e-9) return wave;
    throw std::domain_error("no length has this period");
}

RegularWave by(const WaveOrder& order, RegularWave::Theory theory) {
    return order.length ? of_length(order, theory, *order.length) : of_period(order, theory);
}

}  // namespace

double RegularWave::encounter_period() const { return 2 * pi / std::abs(encounter_frequency()); }
double RegularWave::group_speed_in_water() const { return group_speed_ratio(k() * depth) * speed_in_water; }
double RegularWave::period_in_water() const { return length / speed_in_water; }

double RegularWave::pressure_over_density(double x, double z, double t) const {
    double u, v, w;
    wave_velocity(sum, x, 0, z, t, u, v, w);
    const double past = sum.direction * u + sum.across * v - sum.speed;
    return bernoulli - gravity * z - (past * past + w * w) / 2;
}

RegularWave regular_wave(const WaveOrder& order) {
    using Theory = RegularWave::Theory;
    if (order.theory) {
        RegularWave w = by(order, *order.theory);
        w.why = "as the scene says";
        return w;
    }
    RegularWave full = by(order, Theory::stream_function);
    const RegularWave line = by(order, Theory::linear);
    const double crest = full.crest / line.crest - 1, speed = full.speed_in_water / line.speed_in_water - 1,
                 length = full.length / line.length - 1;
    const double most = std::max({std::abs(crest), std::abs(speed), std::abs(length)});
    if (most < 0.005) {
        RegularWave w = line;
        w.why = fmt::format("the stream function's crest differs from its own by {:.2g} %, below 0.5 %", 100 * most);
        return w;
    }
    full.why = fmt::format(
        "its crest is {:.3g} % of the height above still water, where linear theory has 50 %, and its "
        "speed {:.2g} % above that of linear theory",
        100 * full.crest / full.height, 100 * speed);
    return full;
}

RegularInStream in_stream(const RegularWave& wave) {
    return {.sum = wave.sum, .bernoulli = wave.bernoulli, .carried = wave.sum.direction * wave.transport / wave.depth};
}

}  // namespace tw

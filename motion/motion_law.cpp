#include "motion/motion_law.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "base/numbers.h"

namespace tw {

MotionLaw::At MotionLaw::at(double t) const {
    switch (kind) {
        case Kind::constant: return {rate * t, rate, 0};
        case Kind::ramp: {
            if (t >= ramp) return {rate * (t - ramp / 2), rate, 0};
            const double w = pi / ramp;  // sin^2(w t / 2) = (1 - cos(w t)) / 2
            return {rate / 2 * (t - std::sin(w * t) / w), rate / 2 * (1 - std::cos(w * t)),
                    rate / 2 * w * std::sin(w * t)};
        }
        case Kind::sinusoid: {
            const double w = 2 * pi / period, s = std::sin(w * t + phase), c = std::cos(w * t + phase);
            if (ramp > 0) {  // about its middle, from rest: the amplitude rises as the rate of a ramp
                const double p = pi / ramp;
                const bool up = t < ramp;
                const double f = up ? (1 - std::cos(p * t)) / 2 : 1, df = up ? p / 2 * std::sin(p * t) : 0,
                             ddf = up ? p * p / 2 * std::cos(p * t) : 0;
                return {amplitude * f * s, amplitude * (df * s + f * w * c),
                        amplitude * (ddf * s + 2 * df * w * c - f * w * w * s)};
            }
            return {amplitude * (s - std::sin(phase)), amplitude * w * c, -amplitude * w * w * s};
        }
        case Kind::table: return on_table(times, values, t);
    }
    return {};
}

double MotionLaw::fastest() const {
    if (kind == Kind::sinusoid) {
        double most = std::abs(2 * pi / period * amplitude);
        const int places = ramp > 0 ? static_cast<int>(64 * std::ceil(std::max(1.0, ramp / period))) : 0;
        for (int k = 0; k < places; ++k) most = std::max(most, std::abs(at(ramp * k / places).rate));
        return most;
    }
    return kind == Kind::table ? largest_of_table(times, values).rate : std::abs(rate);
}

double largest_acceleration(const MotionLaw& law) {
    switch (law.kind) {
        case MotionLaw::Kind::constant: return 0;
        case MotionLaw::Kind::ramp: return std::abs(law.rate) * pi / (2 * law.ramp);
        case MotionLaw::Kind::table: return largest_of_table(law.times, law.values).acceleration;
        case MotionLaw::Kind::sinusoid: break;
    }
    double most = std::abs(law.amplitude) * std::pow(2 * pi / law.period, 2);
    const int places = law.ramp > 0 ? static_cast<int>(64 * std::ceil(std::max(1.0, law.ramp / law.period))) : 0;
    for (int k = 0; k < places; ++k) most = std::max(most, std::abs(law.at(law.ramp * k / places).acceleration));
    return most;
}

void MotionLaw::check_table() const {
    if (times.size() != values.size())
        throw InputError(
            fmt::format("{} times and {} values; expected one value for each time", times.size(), values.size()));
    if (times.size() < 2) throw InputError("a table of motion needs two rows or more");
    for (std::size_t k = 1; k < times.size(); ++k)
        if (!(times[k] > times[k - 1]))
            throw InputError(fmt::format("row {} is at {:.6g} s and row {} at {:.6g} s; expected times that rise", k,
                                         times[k - 1], k + 1, times[k]));
    if (const double begin = ends_of_table(times, values).begin; times.front() > 0 && begin != 0)
        throw InputError(
            fmt::format("the table begins at {:.6g} s while it moves at {:.4g} (by its first rows), and "
                        "before its first row it rests; expected rows from 0 s on, or from rest",
                        times.front(), begin));
}

}  // namespace tw

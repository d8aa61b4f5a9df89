#pragma once
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "compare/compare.h"

namespace tw {

struct WaveSamples {
    std::vector<double> t, x;  ///< [s], [unit of the series]
};
/// The known values after `from`, up to `to` [s]; `of_row`: the value in a row.
template <class OfRow>
WaveSamples samples_between(const std::vector<double>& time, double from, double to, OfRow of_row) {
    WaveSamples s;
    for (std::size_t i = 0; i < time.size(); ++i)
        if (time[i] > from && time[i] <= to * (1 + 1e-12) && std::isfinite(of_row(i)))
            s.t.push_back(time[i]), s.x.push_back(of_row(i));
    return s;
}
/// Of a height gauge; empty: the record has none of that name.
inline WaveSamples samples_of(const RunRecord& r, const std::string& gauge, double from, double to) {
    const Column* c = r.series("height", gauge);
    if (!c) return {};
    return samples_between(r.tables.at("height").time, from, to, [&](std::size_t i) { return c->values[i]; });
}

/// Names of the height gauges of all records.
inline std::set<std::string> gauges_of(const Comparison& comparison) {
    std::set<std::string> gauges;
    for (const RunRecord& r : comparison.sources)
        if (const auto found = r.tables.find("height"); found != r.tables.end())
            for (const Column& c : found->second.columns) gauges.insert(c.name);
    return gauges;
}

inline MeanValue unknown_value(const std::string& why) {
    MeanValue m;
    m.why_not = why;
    return m;
}
inline MeanValue known_value(double value, double half_width, double from, double to) {
    MeanValue m;
    m.known = true;
    m.value = value;
    m.half_width = half_width;
    m.from = from, m.to = to;
    return m;
}

}  // namespace tw

#include "compare/truth/reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "compare/metrics/probes.h"
#include "compare/metrics/quantity.h"
#include "compare/verdict/judge.h"
#include "statistics/time_bins.h"

namespace tw {
namespace {

/// The finite samples of a column within the reading's times.
struct Samples {
    std::vector<double> t, x;
};
Samples samples_of(const Reading& r, const Table& table, const Column& column) {
    Samples s;
    for (std::size_t i = 0; i < table.time.size(); ++i)
        if (table.time[i] >= r.from && table.time[i] <= r.to && std::isfinite(column.values[i])) {
            s.t.push_back(table.time[i]);
            s.x.push_back(column.values[i]);
        }
    return s;
}

/// sum of w_i dt_i by trapezia of equal weight for both ends.
double width_of(const std::vector<double>& t, std::size_t i) {
    const double before = i > 0 ? t[i] - t[i - 1] : 0, behind = i + 1 < t.size() ? t[i + 1] - t[i] : 0;
    return (before + behind) / 2;
}

double mean_over(const Samples& s) {
    double sum = 0, width = 0;
    for (std::size_t i = 0; i < s.t.size(); ++i) sum += width_of(s.t, i) * s.x[i], width += width_of(s.t, i);
    return width > 0 ? sum / width : s.x.front();
}

double period_of(const Samples& s) {
    if (s.t.size() < 8) return nan;
    const double span = s.t.back() - s.t.front();
    std::vector<double> w(s.t.size());
    double sum = 0, of_x = 0;
    for (std::size_t i = 0; i < w.size(); ++i) {
        w[i] = width_of(s.t, i) * (1 - std::cos(2 * pi * (s.t[i] - s.t.front()) / span)) / 2;
        sum += w[i], of_x += w[i] * s.x[i];
    }
    const double mean = of_x / sum;
    const auto power = [&](double omega) {
        std::complex<double> c = 0;
        for (std::size_t i = 0; i < w.size(); ++i) c += w[i] * (s.x[i] - mean) * std::polar(1.0, -omega * s.t[i]);
        return std::norm(c);
    };
    // two periods at least, four samples a period at most, eight steps across the window's main lobe
    const double least = 2 * pi * 2 / span, most = pi / 2 * static_cast<double>(s.t.size() - 1) / span,
                 step = 2 * pi / (4 * span);
    double best = 0, at = nan;
    for (double omega = least; omega <= most; omega += step)
        if (const double p = power(omega); p > best) best = p, at = omega;
    if (!std::isfinite(at)) return nan;
    double low = at - step, high = at + step;
    for (int k = 0; k < 60; ++k) {  // the one maximum between them, by thirds
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        (power(a) < power(b) ? low : high) = power(a) < power(b) ? a : b;
    }
    return low <= least ? nan : 2 * pi / ((low + high) / 2);
}

double number_of_samples(const Reading& r, const Samples& s) {
    switch (r.kind) {
        case Reading::Kind::mean: return mean_over(s);
        case Reading::Kind::at: return value_at(s.t, s.x, r.at);
        case Reading::Kind::largest: return *std::ranges::max_element(s.x);
        case Reading::Kind::smallest: return *std::ranges::min_element(s.x);
        case Reading::Kind::crossing: return arrival_time(s.t, s.x, r.threshold);
        case Reading::Kind::period: return period_of(s);
    }
    return nan;
}

std::string why_not(const Reading& r, const Table* table, const Column* column, const Samples& s) {
    if (!table) return fmt::format("the record has no table \"{}\"", r.table);
    if (!column) {
        std::string known;
        for (const Column& c : table->columns) known += (known.empty() ? "" : ", ") + c.name;
        return fmt::format("table \"{}\" of the record has no column \"{}\"; it has: {}", r.table, r.column, known);
    }
    if (s.t.empty()) return "the record has no value in the reading's times";
    const double slack = 2 * (table->time.back() - table->time.front()) / static_cast<double>(table->time.size());
    if (std::isfinite(r.to) && s.t.back() < r.to - slack)
        return fmt::format("the record ends at {:g} s, before the reading does", s.t.back());
    return "";
}

}  // namespace

const std::vector<std::string>& reading_kinds() {
    static const std::vector<std::string> kinds{"mean", "at", "largest", "smallest", "crossing", "period"};
    return kinds;
}

Quantity quantity_of(const Reading& r, const std::string& name, const std::string& label, const RunRecord& record) {
    const auto found = record.tables.find(r.table);
    const Table* table = found == record.tables.end() ? nullptr : &found->second;
    const Column* column = table ? table->find(r.column) : nullptr;
    const Samples s = column ? samples_of(r, *table, *column) : Samples{};
    const bool time = r.kind == Reading::Kind::crossing || r.kind == Reading::Kind::period;
    Quantity q = new_quantity(name, label, time ? "s" : column ? column->unit : "", "read off the run's history");
    MeanValue m;
    m.why_not = why_not(r, table, column, s);
    if (m.why_not.empty()) {
        m.value = number_of_samples(r, s);
        m.known = std::isfinite(m.value);
        m.half_width = 0, m.from = s.t.front(), m.to = s.t.back();
        if (!m.known)
            m.why_not = r.kind == Reading::Kind::crossing ? "the history never crosses the threshold"
                        : r.kind == Reading::Kind::period ? "the history shows no oscillation of two periods or more"
                                                          : "the record does not cover the reading's time";
    }
    q.values.push_back(std::move(m));
    beside(q);
    q.judged_in_grid_study = true;
    return q;
}

}  // namespace tw

// How often the intervals of runs that are ended by statistics/settled_loads.h hold the truth.
//
//   stopping N                  synthetic loads: mean 1, correlated noise, an approach from below; 3 N series of each kind
//   stopping RECORD OFFSET      a long recorded run, begun anew every OFFSET seconds and ended by the rule: its means
//                               against those of the rest of the record
//
// Behind these: interval and lacking of the rule, to the half width that is then given, where others are to be tried.
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>

#include "record/record_numbers.h"
#include "statistics/flow_through.h"
#include "statistics/settled_loads.h"
#include "statistics/settled_mean.h"
#include "statistics/time_bins.h"

namespace {

using namespace tw;

/// The record as it was when its last frame had been taken at `end`.
struct Stop {
    double time = 0;  ///< 0: not within the record
    RunRecord record;
};

/// Grows a record frame by frame, as a run does, until the rule ends it.
Stop ended(const RunRecord& whole, const SettledStop& rule) {
    Stop stop;
    RunRecord& r = stop.record;
    r.attributes = whole.attributes, r.numbers = whole.numbers;
    const Table &frames = whole.tables.at("samples"), &forces = whole.tables.at("forces");
    std::size_t row = 0;
    const auto add_row = [](RunRecord& to, const Table& from, std::size_t i) {
        Table& t = to.table(from.name);
        const std::size_t k = t.append(from.time[i]);
        for (const Column& c : from.columns) t.set(k, c.name, c.unit, c.values[i]);
    };
    for (std::size_t f = 0; f < frames.time.size(); ++f) {
        for (; row < forces.time.size() && forces.time[row] <= frames.time[f] * (1 + 1e-9); ++row)
            add_row(r, forces, row);
        add_row(r, frames, f);
        if (is_look(r, rule) && settled_loads(r, rule).settled) {
            stop.time = frames.time[f];
            return stop;
        }
    }
    return stop;
}

SettledMean mean_of_load(const RunRecord& r, const char* column) {
    SettledRules rules;
    rules.from = number_of(r, "mean_from", 0), rules.flow_through = flow_through_time(r);
    return settled_mean(r.tables.at("forces").time, r.series("forces", column)->values, rules);
}

/// A hull of length 1 at speed 1, means from 1.5 on, frames 1/25 apart, bound 8.
RunRecord synthetic(double sigma, double tau, double A, double theta, std::mt19937& random) {
    RunRecord r;
    r.numbers = {{"mean_from", 1.5}, {"length", 0.76}, {"speed", 1.0}};
    Table &forces = r.table("forces"), &samples = r.table("samples");
    forces.name = "forces", samples.name = "samples";
    constexpr double dt = 0.02, bound = 8;
    std::normal_distribution<double> normal;
    const double rho = std::exp(-dt / tau);
    double state = normal(random);
    std::vector<double>& fz = forces.column("fz", "N").values;
    for (int i = 1; i * dt < bound; ++i) {
        state = rho * state + std::sqrt(1 - rho * rho) * normal(random);
        forces.time.push_back(i * dt);
        fz.push_back(1 - A * std::exp(-i * dt / theta) + sigma * state);
        if (i % 2 == 0) samples.time.push_back(i * dt);
    }
    return r;
}

void coverage_of_synthetic(int series, const SettledStop& rule, double known_to) {
    fmt::print("{:>6} {:>5} {:>6} {:>6}  {:>8} {:>10} {:>10} {:>10} {:>12}\n", "sigma", "tau", "A", "theta", "ended",
               "mean end", "holds", "to width", "bound holds");
    for (const double sigma : {0.003, 0.01, 0.03})
        for (const auto& [A, theta] :
             {std::pair{0.0, 1.0}, {1.0, 0.3}, {1.0, 0.5}, {0.3, 0.7}, {0.3, 1.0}, {0.1, 2.0}}) {
            std::mt19937 random(17);
            int ends = 0, holds = 0, narrow = 0, all = 0, fixed = 0, fixed_holds = 0;
            double time = 0;
            for (const double tau : {0.02, 0.06, 0.2})
                for (int k = 0; k < series; ++k) {
                    const RunRecord whole = synthetic(sigma, tau, A, theta, random);
                    ++all;
                    const Stop stop = ended(whole, rule);
                    // beside it, a run of 4.3 lengths whatever it does, as the demo's
                    RunRecord to_bound = whole;
                    to_bound.rewind(4.3);
                    if (const SettledMean m = mean_of_load(to_bound, "fz"); m.known)
                        ++fixed, fixed_holds += std::abs(m.value - 1) <= m.half_width;
                    if (!(stop.time > 0)) continue;
                    const SettledMean m = mean_of_load(stop.record, "fz");
                    ++ends, time += stop.time;
                    holds += std::abs(m.value - 1) <= std::max(m.half_width, known_to * std::abs(m.value));
                    narrow += std::abs(m.value - 1) <= m.half_width;
                }
            fmt::print("{:6} {:>5} {:6} {:6}  {:7.0f}% {:10.2f} {:9.1f}% {:9.1f}% {:11.1f}%\n", sigma, "all", A, theta,
                       100.0 * ends / all, time / std::max(1, ends), 100.0 * holds / std::max(1, ends),
                       100.0 * narrow / std::max(1, ends), 100.0 * fixed_holds / std::max(1, fixed));
        }
}

RunRecord begun_at(RunRecord r, double offset) {
    for (auto& [name, table] : r.tables) {
        Table later;
        later.name = table.name;
        for (const Column& c : table.columns) later.column(c.name, c.unit);
        for (std::size_t i = 0; i < table.time.size(); ++i) {
            if (table.time[i] < offset) continue;
            later.time.push_back(table.time[i] - offset);
            for (std::size_t c = 0; c < table.columns.size(); ++c)
                later.columns[c].values.push_back(table.columns[c].values[i]);
        }
        table = std::move(later);
    }
    return r;
}

void coverage_of_record(const std::string& file, double offset, const SettledStop& rule, double known_to) {
    RunRecord whole = read_record(file);
    std::erase_if(whole.tables, [](const auto& t) { return t.first != "forces" && t.first != "samples"; });
    whole.frames.clear();
    const double end = whole.tables.at("samples").time.back();
    int looks_that_ended = 0, held = 0, means = 0;
    for (double begin = 0; begin < 0.6 * end; begin += offset) {
        const RunRecord part = begin > 0 ? begun_at(whole, begin) : whole;
        const auto started = std::chrono::steady_clock::now();
        const Stop stop = ended(part, rule);
        const double cost = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
        if (!(stop.time > 0)) {
            fmt::print("from {:7.3f} s: goes on to the end of the record: {}\n", begin,
                       settled_loads(part, rule).sentence());
            continue;
        }
        ++looks_that_ended;
        fmt::print("from {:7.3f} s: ended at {:6.3f} s ({:.3f} s of processor time for all looks):", begin, stop.time,
                   cost);
        const double lift = mean_of_load(stop.record, "fz").value, length = number_of(whole, "length", 0);
        for (const char* column : {"fz", "fx", "my"}) {
            if (!whole.series("forces", column)) continue;
            const SettledMean m = mean_of_load(stop.record, column);
            const Table& forces = part.tables.at("forces");
            SettledRules rest_rules;
            rest_rules.from = stop.time, rest_rules.largest_error = 1;
            const SettledMean rest = settled_mean(forces.time, part.series("forces", column)->values, rest_rules);
            const double scale = std::max(std::abs(m.value), *column == 'm' ? 0.1 * std::abs(lift) * length : 0.0);
            const double width = std::max(m.half_width, known_to * scale);
            const bool in = std::abs(m.value - rest.value) <= std::hypot(width, rest.known ? rest.half_width : 0.0);
            held += in, ++means;
            fmt::print("  {} {:+.2f} % of +-{:.2f}{}", column, 100 * (m.value - rest.value) / scale,
                       100 * m.half_width / scale, in ? "" : " OUTSIDE");
        }
        fmt::print("\n");
    }
    fmt::print("{}: {} ends, {} of {} means hold that of the rest\n", file, looks_that_ended, held, means);
}

}  // namespace

int main(int count, char** words) {
    if (count < 2) return 2;
    const bool of_record = std::filesystem::exists(words[1]);
    const int options = of_record ? 3 : 2;
    tw::SettledStop rule;
    double known_to = rule.known_to;
    if (count > options + 1) rule.interval = std::atof(words[options]), rule.lacking = std::atof(words[options + 1]);
    if (count > options + 2) known_to = std::atof(words[options + 2]);
    if (of_record)
        coverage_of_record(words[1], count > 2 ? std::atof(words[2]) : 0.5, rule, known_to);
    else
        coverage_of_synthetic(std::atoi(words[1]), rule, known_to);
}

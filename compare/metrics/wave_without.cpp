#include "compare/metrics/wave_without.h"

#include <fmt/format.h>

#include <complex>

#include "compare/metrics/quantity.h"
#include "compare/verdict/judge.h"
#include "record/record_numbers.h"
#include "record/wave_twin.h"

namespace tw {

WaveWithout wave_without(const RunRecord& r, const std::string& what, const WavePeriods& periods) {
    const Column* level = r.series(std::string(empty_twin_table), gauge_of_empty_twin(what));
    if (!level) return {};
    return {true, harmonics_of_periods(r.tables.at(std::string(empty_twin_table)).time, periods,
                                       [&](std::size_t i) { return level->values[i]; })};
}

std::string obstacle_left_out(const RunRecord& r) {
    const auto table = r.tables.find(std::string(empty_twin_table));
    if (table == r.tables.end()) return {};
    const std::string start = gauge_of_empty_twin("");
    std::string found;
    for (const Column& column : table->second.columns) {
        if (!column.name.starts_with(start)) continue;
        if (!found.empty()) return {};
        found = column.name.substr(start.size());
    }
    return found;
}

std::string without_twin(const Comparison& comparison, const std::vector<WaveWithout>& waves, const std::string& what) {
    std::string text;
    for (std::size_t k = 0; k < waves.size(); ++k) {
        if (waves[k].known) continue;
        const std::string why = text_of(comparison.sources[k], std::string(no_wave_twin), "it was not run");
        text += fmt::format("; no run without the {} counts ({}: {})", what, method_label(comparison.names[k]), why);
    }
    return text;
}

void add_wave_without(Comparison& comparison, const std::string& name, const std::vector<WaveWithout>& waves,
                      double height, const WavePeriods& periods) {
    Quantity q = new_quantity("wave_without:" + name, fmt::format("Wave at the place of {}, without it", name), "m",
                              fmt::format("twice the amplitude of the first harmonic in the run without it, mean over "
                                          "{} whole periods",
                                          periods.count));
    for (const WaveWithout& w : waves) {
        std::vector<double> heights;
        for (const auto& a : w.wave)
            if (a) heights.push_back(2 * std::abs(*a));
        q.values.push_back(w.known ? mean_over(heights, periods) : unknown_value("no run without it counts"));
    }
    beside(q);
    q.judged_in_grid_study = true;
    Reference reference;
    reference.quantity = q.name, reference.unit = "m", reference.value = height;
    reference.source = "the wave as asked for", reference.remark = "its height from trough to crest";
    comparison.references.push_back(reference);
    comparison.quantities.push_back(std::move(q));
}

}  // namespace tw

#include "compare/grid_study/steps.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/errors.h"
#include "compare/verdict/judge.h"

namespace tw {

namespace {

Validation validate(const GridStudyValue& v, const MeanValue& measured, double target) {
    Validation out;
    if (v.levels.empty() || !measured.known) return out;
    out.E = v.levels.front().value - measured.value;
    if (measured.value != 0) out.per_cent = 100 * out.E / std::abs(measured.value);
    out.verdict = Verdict::not_converged;
    if (!std::isfinite(v.uncertainty)) return out;
    out.U_val = std::hypot(v.uncertainty, measured.half_width);
    out.verdict = holds(out.E, out.U_val, target, std::abs(measured.value));
    return out;
}

/// Throws InputError for a value in another unit.
void hold_against(GridStudy& grid_study, const std::string& source, const std::string& quantity,
                  const std::string& unit, const MeanValue& value) {
    const auto at = std::ranges::find(grid_study.quantities, quantity, &GridStudyQuantity::name);
    if (at == grid_study.quantities.end()) return;
    if (at->unit != unit)
        throw InputError(
            fmt::format("{}: {} is in {}, and in the runs of the study in {}; expected one unit: convert it with "
                        "twinwake import",
                        source, at->label, unit, at->unit));
    Held held{source, value, {}};
    for (const GridStudyValue& v : at->values) held.validations.push_back(validate(v, value, grid_study.agree_within));
    at->held.push_back(std::move(held));
}

/// The half width of a measured quantity's 95 % interval, as the mapping of its column says.
double measured_half_width(const RunRecord& record, const std::string& quantity) {
    static const std::map<std::string, std::string> columns{{"lift", "forces:fz"},
                                                            {"drag", "forces:fx"},
                                                            {"trim_moment", "forces:my"},
                                                            {"wetted_length", "samples:wetted_length"}};
    std::string column;
    if (const auto known = columns.find(quantity); known != columns.end()) column = known->second;
    if (quantity.find("_arrival:") != std::string::npos) return 0;  // a time, not what the column holds
    for (const char* table : {"pressure", "height"})                // "pressure:P1" and "pressure_mean:P1"
        if (const std::size_t colon = quantity.find(':'); colon != std::string::npos && quantity.starts_with(table))
            column = table + quantity.substr(colon);
    const auto at = record.numbers.find("uncertainty:" + column);
    return at == record.numbers.end() ? 0 : at->second;
}

/// The same tank, but for faces that a spacing has moved.
bool same_domain(const std::vector<double>& a, const std::vector<double>& b, double spacing) {
    return std::ranges::equal(a, b, [&](double x, double y) { return std::abs(x - y) <= spacing; });
}

/// What lies within the runs' time: a peak that only the longer measurement saw is none of theirs.
RunRecord within(RunRecord record, double duration) {
    if (!(duration > 0)) return record;
    for (auto& [name, table] : record.tables) {
        const auto inside = [&](double t) { return t >= 0 && t <= duration * (1 + 1e-6); };
        for (Column& c : table.columns) {
            std::vector<double> values;
            for (std::size_t i = 0; i < c.values.size(); ++i)
                if (inside(table.time[i])) values.push_back(c.values[i]);
            c.values = std::move(values);
        }
        std::erase_if(table.time, [&](double t) { return !inside(t); });
    }
    double& its = record.numbers["duration"];
    its = its > 0 ? std::min(its, duration) : duration;
    return record;
}

}  // namespace

std::vector<double> domain_of(const RunRecord& record) {
    std::vector<double> box;
    const auto number = [&](const std::string& name, double otherwise) {
        const auto n = record.numbers.find(name);
        return n == record.numbers.end() ? otherwise : n->second;
    };
    for (const char* axis : {"x", "y", "z"})
        if (axis[0] != 'y' || number("dimensions", 3) == 3)
            for (const char* end : {"min", "max"}) box.push_back(number(fmt::format("domain_{}_{}", axis, end), 0));
    return box;
}

void add_measured(GridStudy& grid_study, const RunRecord& record) {
    const auto text = [&](const std::string& name) {
        const auto at = record.attributes.find(name);
        return at == record.attributes.end() ? std::string() : at->second;
    };
    const std::string source = text("method");
    const GridStudyRun& run = grid_study.sides.front().runs.front();
    if (text("hull_hash") != run.hull_hash)
        throw InputError(
            source +
            ": measured on another hull than that of the study; expected a mapping with the scene of the study");
    if (run.hull_hash.empty() && !same_domain(domain_of(record), run.domain, run.spacing))
        throw InputError(
            fmt::format("{}: measured in another tank than that of the study: it spans {:.4g} m, the tank of the study "
                        "{:.4g} m; expected a mapping with the scene of the study",
                        source, fmt::join(domain_of(record), " "), fmt::join(run.domain, " ")));
    double shortest = HUGE_VAL;
    for (const GridStudySide& side : grid_study.sides)
        for (const GridStudyRun& r : side.runs)
            if (r.duration > 0) shortest = std::min(shortest, r.duration);
    for (const Quantity& q : compare_records({within(record, std::isfinite(shortest) ? shortest : 0)}).quantities) {
        if (q.values.empty() || !q.values[0].known) continue;
        MeanValue value = q.values[0];
        value.half_width = std::hypot(value.half_width, measured_half_width(record, q.name));
        hold_against(grid_study, source, q.name, q.unit, value);
    }
}

void add_references(GridStudy& grid_study) {
    for (const GridStudySide& side : grid_study.sides)
        for (const GridStudyRun& run : side.runs) {
            if (run.references.empty()) continue;
            for (const Reference& r : run.references) {
                MeanValue value;
                value.known = true, value.value = r.value, value.half_width = r.half_width;
                if (r.in_range && !r.of_one_run)
                    hold_against(grid_study, r.remark.empty() ? r.source : r.source + " (" + r.remark + ")", r.quantity,
                                 r.unit, value);
            }
            return;
        }
}

}  // namespace tw

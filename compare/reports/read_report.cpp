#include "compare/reports/two_reports.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/errors.h"
#include "base/own_json.h"

namespace tw {
namespace {

double number_or_null(const nlohmann::json& value) { return value.is_null() ? std::nan("") : value.get<double>(); }

ReportedRun reported_run(const nlohmann::json& from) {
    ReportedRun run{from.at("name").get<std::string>(), {}, {}};
    for (const auto& [name, value] : from.at("numbers").items()) run.numbers[name] = number_or_null(value);
    for (const auto& [name, value] : from.at("attributes").items()) run.attributes[name] = value.get<std::string>();
    return run;
}

ReportedQuantity reported_quantity(const nlohmann::json& from) {
    ReportedQuantity q{from.at("name"), from.at("label"), from.at("unit"), from.at("definition"), {}};
    const auto &values = from.at("values"), &intervals = from.at("intervals");
    for (std::size_t k = 0; k < values.size(); ++k)
        q.values.push_back({number_or_null(values.at(k)), number_or_null(intervals.at(k))});
    return q;
}

}  // namespace

ReportFacts read_report(const std::filesystem::path& file) {
    ReportFacts facts{file, {}, {}};
    read_own_json(file, [&](const nlohmann::json& report) {
        for (const auto& run : report.at("sources")) facts.runs.push_back(reported_run(run));
        for (const auto& quantity : report.at("quantities")) {
            facts.quantities.push_back(reported_quantity(quantity));
            if (facts.quantities.back().values.size() != facts.runs.size())
                throw InputError(file.string() + ": quantity \"" + facts.quantities.back().name + "\" has " +
                                 std::to_string(facts.quantities.back().values.size()) + " values, expected " +
                                 std::to_string(facts.runs.size()) + ", one for each of its sources");
        }
    });
    if (facts.runs.empty())
        throw InputError(file.string() + ": a report without a run; expected a report.json of twinwake run or compare");
    return facts;
}

}  // namespace tw

#include "record/record_numbers.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace tw {

double number_of(const RunRecord& record, const std::string& name, double fallback) {
    const auto found = record.numbers.find(name);
    return found != record.numbers.end() && std::isfinite(found->second) ? found->second : fallback;
}

double number_of_text(const RunRecord& record, const std::string& name, double fallback) {
    const auto found = record.attributes.find(name);
    if (found == record.attributes.end()) return fallback;
    double value = fallback;
    const std::string& text = found->second;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} && std::isfinite(value) ? value : fallback;
}

std::string text_of(const RunRecord& record, const std::string& name, const std::string& fallback) {
    const auto found = record.attributes.find(name);
    return found == record.attributes.end() ? fallback : found->second;
}

bool is_stream(const RunRecord& record) {
    const auto motion = record.attributes.find("motion");
    return motion != record.attributes.end() ? motion->second == "stream" : number_of(record, "speed", 0) > 0;
}

bool has_moving_bodies(const RunRecord& record) {
    return std::ranges::any_of(record.tables, [](const auto& t) { return t.first.starts_with(body_table("")); });
}

}  // namespace tw

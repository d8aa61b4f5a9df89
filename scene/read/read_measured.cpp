#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "scene/read/read.h"
#include "text/name.h"
#include "text/units.h"

namespace tw {

namespace {

constexpr double same = 0.005;  ///< of a speed or a length [-]

/// Of a quantity of the report: a name, and behind colons those of its body or place, as in heave_response:hull.
std::string quantity_named(SceneSection& s) {
    const std::string name = s.text("quantity").value_or("");
    if (!is_name(name, 80, ":"))
        s.fail("quantity",
               "expected the name of a quantity of the report, of letters, digits, '_' and ':', as \"lift\" or "
               "\"heave_response:hull\"");
    return name;
}

MeasuredRow read_row(SceneSection& s) {
    const auto required = [&](const std::string& key, const char* expected) {
        std::optional<std::string> text = s.text(key);
        if (!text || text->empty()) s.fail(key, fmt::format("missing; expected {}", expected));
        return *text;
    };
    MeasuredRow row;
    MeasuredValue& m = row.value;
    if (!s.has("quantity")) s.fail("quantity", "missing; expected the name of a quantity of the report, as \"lift\"");
    m.quantity = quantity_named(s);
    const std::string value = required("value", "the measured value with its unit, as \"71.25 N\"");
    m.unit = unit_after_number(value);
    const auto read = [&](const char* key, const std::string& text) {
        try {
            return quantity(text, m.unit);
        } catch (const UnitError& e) { s.fail(key, e.what()); }
    };
    m.value = read("value", value);
    if (const auto uncertainty = s.text("uncertainty")) {
        m.half_width = unit_after_number(*uncertainty) == "%"
                           ? quantity(uncertainty->substr(0, uncertainty->find('%')), "-") / 100 * std::abs(m.value)
                           : read("uncertainty", *uncertainty);
        if (!(m.half_width > 0)) s.fail("uncertainty", "expected a half width above 0, or no uncertainty");
    }
    m.source = required("source", "who measured it, as \"Fridsma 1969, configuration A\"");
    row.speed = s.number("speed");
    row.wave_length = s.number("wave_length");
    return row;
}

bool near(double a, double b) { return std::abs(a - b) <= same * b; }

/// Two rows of one quantity belong to two speeds or to two waves.
void refuse_second(const MeasuredRow& row, const std::vector<MeasuredRow>& before, SceneSection& s) {
    const auto differ = [](std::optional<double> a, std::optional<double> b) { return a && b && !near(*a, *b); };
    for (const MeasuredRow& other : before)
        if (other.value.quantity == row.value.quantity && !differ(row.speed, other.speed) &&
            !differ(row.wave_length, other.wave_length))
            s.fail("quantity", fmt::format("{} has a measured value already; give each quantity one, or each of "
                                           "several its own speed or wave_length",
                                           row.value.quantity));
}

}  // namespace

std::vector<MeasuredRow> read_measured(std::vector<SceneSection>& sections, const Scene& scene) {
    std::vector<MeasuredRow> all;
    for (SceneSection& s : sections) {
        MeasuredRow row = read_row(s);
        if (row.speed && scene.motion.kind != Motion::Kind::stream)
            s.fail("speed", "there is no stream; remove this key");
        if (row.wave_length && !(scene.wave_asked.height > 0 && scene.wave_asked.spectrum == "regular"))
            s.fail("wave_length", "there is no regular wave; remove this key");
        refuse_second(row, all, s);
        s.finish();
        all.push_back(std::move(row));
    }
    return all;
}

void take_measured(std::vector<MeasuredRow> rows, const SceneOverrides& changed, Scene& scene) {
    const bool turned = changed.trim && !scene.hull_is_free();
    for (MeasuredRow& row : rows) {
        const bool of_this_speed = row.speed ? near(scene.motion.speed, *row.speed) : !changed.speed.has_value(),
                   of_this_wave = row.wave_length ? scene.wave && near(scene.wave->length, *row.wave_length)
                                                  : !changed.wave_length.has_value();
        if (of_this_speed && of_this_wave && !turned && !changed.hull_file)
            scene.measured.push_back(std::move(row.value));
    }
    scene.measured_of_others = rows.size() - scene.measured.size();
}

}  // namespace tw

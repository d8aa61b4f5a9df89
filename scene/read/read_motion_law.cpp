#include <fmt/format.h>

#include "base/errors.h"
#include "scene/read/read.h"

namespace tw {
namespace {

/// Unit vector of `along` or `about`.
Vec3 read_axis(SceneSection& s, const std::string& key, bool flat) {
    const Vec3 v = s.vector(key).value();
    if (!(v.norm() > 0)) s.fail(key, "has no direction; expected a vector other than zero");
    const Vec3 axis = v.normalized();
    if (flat && (key == "about" ? axis.cwiseAbs().y() < 1 : axis.y() != 0))
        s.fail(key, key == "about" ? "two dimensions turn about y alone; expected [0, 1, 0]"
                                   : "leaves the plane y = 0 of two dimensions; expected [x, 0, z]");
    return axis;
}

}  // namespace

MotionLaw read_motion_law(SceneSection& s, bool flat) {
    MotionLaw law;
    const auto kind = s.choice("law");
    if (!kind)
        s.fail("law", "missing; a prescribed motion needs law = \"constant\", \"ramp\", \"sinusoid\" or \"table\"");
    if (s.has("along") == s.has("about"))
        s.fail(s.has("about") ? "about" : "along",
               "expected one of along = [x, y, z] (a direction) and about = [x, y, z] (an axis)");
    law.turns = s.has("about");
    law.axis = read_axis(s, law.turns ? "about" : "along", flat);
    const std::string path = law.turns ? "rad" : "m", rate = path + "/s";
    const auto required = [&](const std::string& key, const std::string& unit, const Range& range = any_value) {
        const auto value = s.number(key, unit, range);
        if (!value) s.fail(key, fmt::format("missing; law = \"{}\" needs it", *kind));
        return *value;
    };
    if (*kind == "constant" || *kind == "ramp") {
        law.kind = *kind == "ramp" ? MotionLaw::Kind::ramp : MotionLaw::Kind::constant;
        law.rate = required("rate", rate);
        if (*kind == "ramp") law.ramp = required("ramp", "s", positive);
    } else if (*kind == "sinusoid") {
        law.kind = MotionLaw::Kind::sinusoid;
        law.amplitude = required("amplitude", path);
        law.period = required("period", "s", positive);
        law.phase = s.number("phase", law.phase);
        if (s.has("ramp")) law.ramp = required("ramp", "s", positive);
    } else {
        law.kind = MotionLaw::Kind::table;
        const auto times = s.numbers("times"), values = s.numbers("values", path, 0);
        if (!times || !values) s.fail(times ? "values" : "times", "missing; law = \"table\" needs times and values");
        law.times = *times;
        law.values = *values;
        try {
            law.check_table();
        } catch (const InputError& e) { s.fail("times", e.what()); }
    }
    return law;
}

}  // namespace tw

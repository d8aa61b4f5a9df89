// A tank that moves as prescribed: its keys, and what cannot be solved in one.
#include <cmath>

#include <fmt/format.h>

#include "scene/defaults.h"
#include "scene/read/check_scene.h"

namespace tw {

std::optional<MovingFrame> read_tank_motion(SceneSection& s, int dimensions) {
    if (!s.has("law")) {
        for (const SceneKey& key : scene_keys())
            if (key.section == "tank" && s.has(key.name) && key.effect.empty() && key.name != "size" &&
                key.name != "min" && key.name != "max")
                s.fail(key.name,
                       "says how a tank moves, and law is missing; expected law = \"constant\", \"ramp\", "
                       "\"sinusoid\" or \"table\", or a tank at rest without this key");
        return {};
    }
    MovingFrame frame;
    frame.law = read_motion_law(s, dimensions == 2);
    const auto pivot = s.vector("pivot");
    if (pivot && !frame.law.turns)
        s.fail("pivot", "is a point of the axis of a rotation, and this tank moves along a direction; remove it");
    frame.pivot = pivot.value_or(Vec3::Zero());
    if (frame.law.kind == MotionLaw::Kind::sinusoid && frame.law.amplitude == 0)
        s.fail("amplitude", "a tank with this amplitude does not move; expected another one, or no law");
    if (frame.law.turns && std::abs(frame.law.at(0).rate) > 1e-9 * frame.law.fastest())
        s.fail(frame.law.kind == MotionLaw::Kind::sinusoid ? "phase" : "law",
               fmt::format("the rotation begins with {:.4g} rad/s, and water at rest cannot follow at once; expected "
                           "one that begins from rest: a sinusoid with ramp, about its middle, or with phase = \"90 "
                           "deg\", from its end; law = \"ramp\" or \"table\"",
                           frame.law.at(0).rate));
    return frame;
}

void check_tank_motion(const Scene& scene, Sections& s) {
    if (!scene.tank_motion) return;
    if (scene.effect_on("forcing_zones"))
        s.effects.fail("forcing_zones", "they hold the water to a tank at rest; remove this effect");
}

double fastest_wall(const Scene& scene) {
    if (!scene.tank_motion) return 0;
    const MotionLaw& law = scene.tank_motion->law;
    if (!law.turns) return law.fastest();
    double reach = 0;
    for (int corner = 0; corner < 8; ++corner) {
        Vec3 p;
        for (int a = 0; a < 3; ++a) p[a] = (corner >> a & 1 ? scene.domain.as_asked.max : scene.domain.as_asked.min)[a];
        reach = std::max(reach, (p - scene.tank_motion->pivot).cross(law.axis).norm());
    }
    return reach * law.fastest();
}

}  // namespace tw

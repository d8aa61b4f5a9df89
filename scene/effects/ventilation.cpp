#include <fmt/format.h>

#include "scene/effects/part.h"

namespace tw::effect_parts {
namespace {

/// Below this speed a smooth sphere that water wets perfectly holds it [m/s] (Duez, Ybert, Clanet & Bocquet 2007,
/// doi:10.1038/nphys545).
constexpr double wetted_bodies_hold_below = 7;

EffectChoice plan_ventilation(const EffectQuestion& q) {
    EffectChoice c = q.choice(true);
    c.reason = fmt::format(
        "separation at ambient pressure: water leaves a wall where its pressure would fall below that of the air, "
        "beginning at the free surface ({:.3g} m/s{}); deep in the water suction remains",
        q.flow.speed,
        q.flow.speed < wetted_bodies_hold_below ? ": a smooth body that water wets perfectly may hold it below 7 m/s"
                                                : "");
    c.influence =
        influence("60 % and more on round bodies that water would cling to (a cylinder in a free jet)", "the same",
                  "where the sheet leaves, and how steep", "without suction at a wall it changes nothing");
    c.cost = 0.05;
    return c;
}

}  // namespace

EffectPart ventilation() {
    return {.name = "ventilation",
            .meaning =
                "Air gets between water and walls from the free surface on: walls hold no water under tension "
                "there.",
            .solved = EffectPart::Solved::by_both_methods,
            .plan = plan_ventilation};
}

}  // namespace tw::effect_parts

#include "foam_cases/files/case_files.h"
#include "scene/water/tailwater.h"
#include "scene/water/water_blocks.h"

namespace tw {
namespace {

/// Boxes of water as wide as needed: a face of a block that lies on the domain's side reaches beyond it.
std::vector<Box> water_boxes(const CasePlan& plan) {
    const Scene& scene = *plan.scene;
    const Box& d = scene.domain.box;
    const Vec3 beyond = d.size();
    if (plan.half_space) return {Box{d.min - beyond, Vec3(d.max.x() + beyond.x(), d.max.y() + beyond.y(), 0)}};
    std::vector<Box> boxes = blocks_of_water(scene);
    for (Box& b : boxes)
        for (int a = 0; a < 3; ++a) {
            if (b.min[a] <= d.min[a]) b.min[a] -= beyond[a];
            if (b.max[a] >= d.max[a]) b.max[a] += beyond[a];
            if (a == 1 && scene.domain.dimensions == 2)
                b.min[a] = d.min[a] - beyond[a], b.max[a] = d.max[a] + beyond[a];
        }
    return boxes;
}

}  // namespace

/// system/setFieldsDict: water into cells whose centre lies in a block (block faces are cell faces, see case_plan.h),
/// and onto the inlet. Water of another depth behind starts with its own speed.
std::string set_fields_dict(const CasePlan& plan) {
    const bool has_inlet = plan.stream;
    const auto value = [](int v) { return Value::sequence({Word("volScalarFieldValue alpha.water"), v}); };
    const std::optional<Tailwater> tail = tailwater(*plan.scene);
    const std::vector<Box> boxes = water_boxes(plan);
    List regions;
    for (const Box& b : boxes) {
        List values{value(1)};
        if (tail && &b == &boxes.back())
            values.push_back(Value::sequence({Word("volVectorFieldValue U"), Vec3(tail->speed, 0, 0)}));
        const Dictionary region{{"box", Value::sequence({b.min, b.max})}, {"fieldValues", values}};
        regions.push_back(Value::named(Word("boxToCell"), region));
        if (has_inlet) regions.push_back(Value::named(Word("boxToFace"), region));
    }
    return foam_file("dictionary", "setFieldsDict", {{"defaultFieldValues", List{value(0)}}, {"regions", regions}});
}

}  // namespace tw

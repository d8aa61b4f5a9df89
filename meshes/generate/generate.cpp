#include "meshes/generate.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/errors.h"
#include "meshes/generate/shapes.h"

namespace tw {
namespace {
template <class List>
std::string names(const List& list) {
    std::string text;
    for (const auto& item : list) text += (text.empty() ? "" : ", ") + item.name;
    return text;
}
}  // namespace

const std::vector<HullShape>& hull_shapes() {
    static const std::vector<HullShape> shapes{prismatic_shape(), fridsma_shape(), seaplane_shape(), wigley_shape(),
                                               wedge_shape(),     plate_shape(),   box_shape(),      cylinder_shape(),
                                               sphere_shape(),    torpedo_shape()};
    return shapes;
}

Surface make_hull(const std::string& shape, const std::map<std::string, double>& values) {
    const auto s = std::ranges::find(hull_shapes(), shape, &HullShape::name);
    if (s == hull_shapes().end())
        throw InputError(fmt::format("unknown hull shape \"{}\"; known: {}", shape, names(hull_shapes())));
    std::map<std::string, double> all;
    for (const HullParameter& p : s->parameters) all[p.name] = p.fallback;
    for (const auto& [name, value] : values) {
        const auto p = std::ranges::find(s->parameters, name, &HullParameter::name);
        if (p == s->parameters.end())
            throw InputError(fmt::format("hull shape \"{}\" has no parameter \"{}\"; it has: {}", shape, name,
                                         names(s->parameters)));
        if (!(value >= p->min && value <= p->max))
            throw InputError(fmt::format("hull shape \"{}\": {} = {:g} {}; expected {:g} to {:g}: {}", shape, name,
                                         value, p->kind, p->min, p->max, p->meaning));
        all[name] = value;
    }
    return s->make(all);
}

}  // namespace tw

#include "sph_solver/bodies/contact.h"

#include <fmt/format.h>

#include "sph_solver/bodies/samples.h"

namespace tw {
namespace {

/// Of the surface as it stands now.
Box bounds_of(const Body& body) {
    Box box{Vec3::Constant(1e300), Vec3::Constant(-1e300)};
    for (const Vec3& p : body.surface().points) {
        const Vec3 x = body.now(p);
        box.min = box.min.cwiseMin(x);
        box.max = box.max.cwiseMax(x);
    }
    return box;
}

bool apart(const Box& a, const Box& b, double gap) {
    return ((a.min - b.max).array() > gap).any() || ((b.min - a.max).array() > gap).any();
}

}  // namespace

Contacts::Contacts(const std::vector<Body>& bodies, const Surroundings& around, double dp)
    : bodies_(bodies), around_(around), dp_(dp), skin_(bodies.size()) {
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (bodies[b].fixed()) continue;
        const Surface& surface = bodies[b].surface();
        skin_[b] = around.dimensions == 2 ? SurfaceSamples::of_section(surface, dp).points.places
                                          : SurfaceSamples(surface, dp, surface.bounds()).points.places;
    }
}

std::string Contacts::with_domain(const Body& body) const {
    static constexpr const char* sides[3][2] = {{"the wall at low x", "the wall at high x"},
                                                {"the wall at low y", "the wall at high y"},
                                                {"the floor", "the lid"}};
    const Box box = bounds_of(body), &domain = around_.domain;
    for (int a = 0; a < 3; ++a) {
        if (a == 1 && around_.dimensions == 2) continue;
        const auto axis = static_cast<std::size_t>(a);
        if (around_.mirrors.on[axis][0] && box.min[a] <= domain.min[a]) return "touches " + std::string(sides[axis][0]);
        if (around_.mirrors.on[axis][1] && box.max[a] >= domain.max[a]) return "touches " + std::string(sides[axis][1]);
        if (box.max[a] < domain.min[a] || box.min[a] > domain.max[a]) return "has left the domain";
    }
    return {};
}

std::string Contacts::found() const {
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        if (bodies_[b].fixed()) continue;
        if (const std::string wall = with_domain(bodies_[b]); !wall.empty())
            return fmt::format("body {} {}", bodies_[b].name(), wall);
        const Box own = bounds_of(bodies_[b]);
        for (std::size_t other = 0; other < bodies_.size(); ++other) {
            if (other == b || apart(own, bounds_of(bodies_[other]), dp_)) continue;
            for (const Vec3& at : skin_[b])
                if (bodies_[other].query().nearest(bodies_[other].at_start(bodies_[b].now(at)), dp_).distance < dp_ / 2)
                    return fmt::format("body {} touches {}", bodies_[b].name(), bodies_[other].name());
        }
    }
    return {};
}

}  // namespace tw

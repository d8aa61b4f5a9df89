#include "sph_solver/bodies/collisions.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "base/gap.h"
#include "sph_solver/bodies/samples.h"

namespace tw {
namespace {

/// Where a body is asked whether it touches something: on its surface at the start.
std::vector<Vec3> places_on(const Surface& surface, const Surroundings& around, double dp) {
    return around.dimensions == 2 ? SurfaceSamples::of_section(surface, dp).points.places
                                  : SurfaceSamples(surface, dp, surface.bounds()).points.places;
}

/// The wall of the tank, other than those with which the contact of `body` is solved, that a place [m] has come to
/// within `gap` of; empty: none.
std::string wall_at(const Vec3& x, const Surroundings& around, double gap, const Body* body = nullptr) {
    static constexpr const char* sides[3][2] = {{"the wall at low x", "the wall at high x"},
                                                {"the wall at low y", "the wall at high y"},
                                                {"the floor", "the lid"}};
    const auto& on = around.mirrors.on;
    const auto solved = [&](int axis, double inward) { return body && body->meets_wall(inward * Vec3::Unit(axis)); };
    for (std::size_t a = 0; a < 3; ++a) {
        if (a == 1 && around.dimensions == 2) continue;
        const auto axis = static_cast<int>(a);
        if (on[a][0] && x[axis] <= around.domain.min[axis] + gap && !solved(axis, 1)) return sides[a][0];
        if (on[a][1] && x[axis] >= around.domain.max[axis] - gap && !solved(axis, -1)) return sides[a][1];
    }
    return {};
}

}  // namespace

Collisions::Collisions(const Bodies& bodies, const Surroundings& around, double dp)
    : bodies_(bodies), around_(around), dp_(dp), on_surface_(bodies.size()) {
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (bodies[b]->fixed()) continue;
        const std::vector<Vec3> places = places_on(bodies[b]->surface(), around, dp);
        on_surface_[b] = bodies[b]->attach(bodies[b]->is_deformable() ? clear_at_start(b, places) : places);
    }
}

/// Those of some places on a body that are clear of walls and of the other solids at the start.
std::vector<Vec3> Collisions::clear_at_start(std::size_t body, const std::vector<Vec3>& places) const {
    const auto beside = [&](const Vec3& x) {
        if (!wall_at(x, around_, dp_).empty()) return true;
        for (std::size_t other = 0; other < bodies_.size(); ++other)
            if (other != body && bodies_[other]->query().nearest(x, 2 * dp_).distance < dp_) return true;
        return false;
    };
    std::vector<Vec3> clear;
    std::ranges::remove_copy_if(places, std::back_inserter(clear), beside);
    return clear;
}

std::string Collisions::of_a_deformable_one(std::size_t body, double gap) const {
    for (std::size_t k = 0; k < on_surface_[body]->size(); ++k) {
        const Vec3 x = on_surface_[body]->place(k);
        if (const std::string wall = wall_at(x, around_, gap, bodies_[body].get()); !wall.empty())
            return "touches " + wall;
        for (std::size_t other = 0; other < bodies_.size(); ++other)
            if (other != body &&
                bodies_[other]->query().nearest(bodies_[other]->at_start(x), dp_ + gap).distance < dp_ / 2 + gap)
                return "touches " + bodies_[other]->name();
    }
    return with_edge(body);
}

std::string Collisions::with_domain(const Body& body, double gap) const {
    const Box& domain = around_.domain;
    Box box = body.bounds();
    for (int a = 0; a < 3; ++a)  // across a plane of symmetry, or clear of the walls as at the start
        if (body.stays_along(a)) box.min[a] = box.max[a] = 0.5 * (domain.min[a] + domain.max[a]);
    for (const Vec3& corner : {box.min, box.max})
        if (const std::string wall = wall_at(corner, around_, gap, &body); !wall.empty()) return "touches " + wall;
    for (int a = 0; a < 3; ++a) {
        if (a == 1 && around_.dimensions == 2) continue;
        if (box.max[a] < domain.min[a] || box.min[a] > domain.max[a]) return "has left the domain";
    }
    if (around_.stream && box.min.x() < domain.min.x()) return "has come to the inlet";
    if (around_.stream && box.max.x() > domain.max.x()) return "has come to the outlet";
    return {};
}

std::string Collisions::with_edge(std::size_t body) const {
    constexpr double nearest = 6;  // spacings: what buffer particles and dummies fill on both sides of an edge
    if (!zone_) return {};
    for (std::size_t k = 0; k < on_surface_[body]->size(); ++k)
        if (const Vec3 x = on_surface_[body]->place(k); x.z() < 0 && zone_->outside(x) > -nearest * dp_)
            return fmt::format("has moved to within {:g} spacings of the edge of the finest particles ([sph] zone)",
                               nearest);
    return {};
}

std::string Collisions::of_rigid(std::size_t b, double gap) const {
    if (const std::string wall = with_domain(*bodies_[b], gap); !wall.empty()) return wall;
    if (const std::string edge = with_edge(b); !edge.empty()) return edge;
    const Box own = bodies_[b]->bounds();
    for (std::size_t other = 0; other < bodies_.size(); ++other) {
        const Body& solid = *bodies_[other];
        if (other == b || gap_of_boxes(own, solid.bounds()) > dp_ + gap) continue;
        for (std::size_t k = 0; k < on_surface_[b]->size(); ++k)
            if (solid.query().nearest(solid.at_start(on_surface_[b]->place(k)), dp_ + gap).distance < dp_ / 2 + gap)
                return "touches " + solid.name();
    }
    return {};
}

std::string Collisions::found(double gap) const {
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        if (bodies_[b]->fixed()) continue;
        const std::string found = bodies_[b]->is_deformable() ? of_a_deformable_one(b, gap) : of_rigid(b, gap);
        if (!found.empty()) return fmt::format("body {} {}", bodies_[b]->name(), found);
    }
    return {};
}

}  // namespace tw

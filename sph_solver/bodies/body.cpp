#include "sph_solver/bodies/body.h"

#include <algorithm>
#include <stdexcept>

#include "meshes/section.h"
#include "sph_solver/bodies/elastic/elastic_body.h"
#include "sph_solver/bodies/rigid_in_water.h"

namespace tw {

BodySetup::BodySetup(std::shared_ptr<const ElasticSetup> setup)
    : surface(wetted_surface_of(*setup)), elastic(std::move(setup)) {}

std::unique_ptr<Body> Body::of(BodySetup setup) {
    if (setup.elastic) return std::make_unique<ElasticBody>(std::move(setup));
    if (setup.moving) return std::make_unique<RigidInWater>(std::move(setup));
    return std::make_unique<Body>(std::move(setup));
}

Body::Body(BodySetup setup) : setup_(std::move(setup)), query_(setup_.surface) {}

Surface Body::surface_now(std::optional<double> span) const {
    Surface surface = span ? with_span(setup_.surface, *span) : setup_.surface;
    for (Vec3& p : surface.points) p = now(p);
    return surface;
}

Dummies Body::dummies(const DummyLattice& lattice) const {
    return make_dummies(query(), surface().bounds(), lattice.dp, lattice.depth, lattice.region, lattice.dimensions);
}

std::unique_ptr<Attached> Body::attach(std::vector<Vec3> at_start) const {
    return std::make_unique<Attached>(std::move(at_start));
}

void Body::restore(std::span<const double> state) {
    if (!state.empty()) throw std::invalid_argument("the body is fixed");
}

bool all_fixed(const Bodies& bodies) {
    return std::ranges::all_of(bodies, [](const auto& body) { return body->fixed(); });
}

}  // namespace tw

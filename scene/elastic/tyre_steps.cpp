#include "scene/elastic/tyre_steps.h"

#include <cmath>

#include "structure/solid/plane_contact.h"

namespace tw {

double TyreSteps::longest() const {
    constexpr double reserve = 0.7;  // as of ElasticSolid::of_limit
    return reserve / std::hypot(1 / of_elements, 1 / of_contact);
}

TyreSteps steps_of(const ElasticTyre& tyre, const structure::Solid& solid) {
    TyreSteps steps;
    steps.of_elements = solid.explicit_step(Eigen::VectorXd::Zero(solid.dofs()));
    steps.of_contact = 2 / structure::PlaneContact(solid, "outside", 0, tyre.contact_stiffness()).highest_frequency();
    steps.elements = static_cast<int>(solid.elements().size());
    return steps;
}

double least_contact_depth(const ElasticTyre& tyre, const TyreSteps& steps) {
    constexpr double finest = 10;
    const double finer = steps.of_elements / steps.of_contact;  // as the root of the stiffness
    return tyre.contact_depth * std::pow(finer / finest, 2);
}

}  // namespace tw

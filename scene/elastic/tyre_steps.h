#pragma once
#include "scene/elastic/elastic_tyre.h"

namespace tw {

/// How the water's steps are cut for a tyre (sph_solver/bodies/elastic/solid_in_time.h): by the explicit limits of its
/// elements and of its contact with the floor, 2 / omega [s].
struct TyreSteps {
    double of_elements = 0, of_contact = 0;  ///< [s]
    int elements = 0;
    /// Of both together, with the engine's reserve [s].
    double longest() const;
};
TyreSteps steps_of(const ElasticTyre& tyre, const structure::Solid& solid);

/// The smallest contact depth whose contact cuts the steps no more than ten times as fine as the rubber does [m].
double least_contact_depth(const ElasticTyre& tyre, const TyreSteps& steps);

}  // namespace tw

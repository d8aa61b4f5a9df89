#include <array>

#include "scene/elastic/elastic_plate.h"
#include "sph_solver/bodies/elastic/elastic_body.h"
#include "sph_solver/bodies/elastic/interface.h"

namespace tw {
namespace {

PenaltyContact penalty_of(const ElasticPlate& plate) {
    PenaltyContact contact;
    contact.law = plate.contact == "nonlinear"  ? PenaltyContact::Law::nonlinear
                  : plate.contact == "adaptive" ? PenaltyContact::Law::adaptive
                                                : PenaltyContact::Law::linear;
    contact.factor = plate.contact_factor;
    return contact;
}

struct Row {
    const char* name;  ///< [[body]] coupling
    Interface (*make)(const ElasticPlate&);
};
constexpr std::array rows{
    Row{"pressure", [](const ElasticPlate&) { return pressure_interface(); }},
    Row{"penalty", [](const ElasticPlate& plate) { return penalty_interface(penalty_of(plate)); }},
    Row{"background", [](const ElasticPlate&) { return background_interface(); }},
};

}  // namespace

Interface interface_of(const ElasticPlate& plate) {
    for (const Row& row : rows)
        if (plate.coupling == row.name) return row.make(plate);
    throw std::logic_error("no coupling " + plate.coupling);
}

}  // namespace tw

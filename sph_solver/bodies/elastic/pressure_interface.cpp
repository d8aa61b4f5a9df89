#include "sph_solver/bodies/elastic/elastic_body.h"
#include "sph_solver/bodies/elastic/interface.h"

namespace tw {
namespace {

class PressureInterface : public WaterInterface {
public:
    Dummies dummies(const ElasticBody& body, const DummyLattice& lattice) const override {
        return body.Body::dummies(lattice);
    }
};

}  // namespace

Interface pressure_interface() { return std::make_shared<PressureInterface>(); }

}  // namespace tw

#include "sph_solver/bodies/elastic/elastic_body.h"
#include "sph_solver/bodies/elastic/interface.h"

namespace tw {
namespace {

/// The nodes as a layer of particles half a spacing under each of the two wet faces, with the volume of their area of
/// that layer. Three dimensions.
class BackgroundInterface : public WaterInterface {
public:
    Dummies dummies(const ElasticBody& body, const DummyLattice& lattice) const override {
        const Surface& surface = body.surface();
        std::vector<Vec3> area(surface.points.size(), Vec3::Zero());  // twice, of the triangles round each
        for (std::size_t t = 0; t < surface.triangles.size(); ++t)
            for (const int n : surface.triangles[t])
                area[static_cast<std::size_t>(n)] += surface.area_vector2(static_cast<int>(t));
        Dummies d;
        for (std::size_t n = 0; n < area.size(); ++n) {
            d.places.push_back(surface.points[n] - lattice.dp / 2 * area[n].normalized());
            d.volumes.push_back(area[n].norm() / 6 * lattice.dp);
        }
        return d;
    }
};

}  // namespace

Interface background_interface() { return std::make_shared<BackgroundInterface>(); }

}  // namespace tw

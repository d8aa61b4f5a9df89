// Control volumes of cells: faces, pressure and weight of one volume.
#include <gtest/gtest.h>

#include "sph_solver/measure/control_volume.h"

namespace tw::test {
namespace {

// Water at rest carries itself: pressure on the faces and weight of what lies inside cancel, whatever the shape.
TEST(ControlVolume, OfStillWaterHasNoForce) {
    constexpr double rho = 1000, g = 9.81, size = 0.1;
    const Box box{Vec3(-1, -1, -1.5), Vec3(1, 1, 0.5)};
    for (const bool shaped : {false, true}) {
        ControlVolume cv(box, size, 3,
                         shaped ? [](const Vec3& x) { return x.norm() < 0.83; } : std::function<bool(const Vec3&)>());
        PointSamples& faces = cv.faces();
        const std::size_t n = faces.places.size();
        faces.support.assign(n, 1);
        faces.flux.assign(3 * n, 0);
        for (std::size_t k = 0; k < n; ++k)
            for (std::size_t a = 0; a < 3; ++a)
                faces.flux[3 * k + a] = static_cast<float>(rho * g * (0.5 - faces.places[k].z()));
        double volume = 0;
        for (double x = -1.025; x < 1.1; x += size / 2)
            for (double y = -1.025; y < 1.1; y += size / 2)
                for (double z = -1.525; z < 0.6; z += size / 2) volume += cv.inside(x, y, z) * size * size * size / 8;
        EXPECT_NEAR(volume, shaped ? 4 * M_PI / 3 * 0.83 * 0.83 * 0.83 - 0.246 : 8, shaped ? 0.05 : 1e-9);
        cv.add_impulse(rho * volume, Vec3(0, 0, -g), 1);
        EXPECT_LT(cv.state().impulse.norm(), 1e-5 * rho * g * volume) << shaped;
    }
}

}  // namespace
}  // namespace tw::test

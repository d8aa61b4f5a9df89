// Control volumes of cells: faces, pressure and weight of one volume.
#include <gtest/gtest.h>

#include "sph_solver/levels/control_volume.h"

namespace tw::test {
namespace control_volume_test {

// Water at rest carries itself: pressure on the faces and weight of what lies inside cancel, whatever the shape.
TEST(ControlVolume, OfStillWaterHasNoForce) {
    constexpr double rho = 1000, g = 9.81, size = 0.1;
    const Box box{Vec3(-1, -1, -1.5), Vec3(1, 1, 0.5)};
    for (const bool shaped : {false, true}) {
        ControlVolume::Shape shape;
        if (shaped) shape.takes = [](const Vec3& x) { return x.norm() < 0.83; };
        ControlVolume cv(box, size, shape);
        PointSamples& faces = cv.faces();
        const std::size_t n = faces.places.size();
        faces.flux.assign(6 * n, 0);
        for (std::size_t k = 0; k < n; ++k)
            for (const std::size_t a : {0, 3, 5})
                faces.flux[6 * k + a] = static_cast<float>(rho * g * (0.5 - faces.places[k].z()));
        double volume = 0;
        for (double x = -1.075; x < 1.1; x += size / 2)
            for (double y = -1.075; y < 1.1; y += size / 2)
                for (double z = -1.575; z < 0.6; z += size / 2) volume += cv.share(x, y, z) * size * size * size / 8;
        EXPECT_NEAR(volume, shaped ? 4 * M_PI / 3 * 0.83 * 0.83 * 0.83 - 0.246 : 8, shaped ? 0.05 : 1e-9);
        cv.add_impulse(rho * volume, Vec3(0, 0, -g), 1);
        EXPECT_LT(cv.state().impulse.norm(), 1e-5 * rho * g * volume) << shaped;
    }
}

// What pulls along the faces counts: a flux P_xz that grows with z takes its slope times the volume of momentum along
// x.
TEST(ControlVolume, HasTheMomentumThatPullsAlongItsFaces) {
    constexpr double slope = 3;
    ControlVolume cv({Vec3(-1, -1, -1), Vec3(1, 1, 1)}, 0.25, {});
    PointSamples& faces = cv.faces();
    faces.flux.assign(6 * faces.places.size(), 0);
    for (std::size_t k = 0; k < faces.places.size(); ++k)
        faces.flux[6 * k + 2] = static_cast<float>(slope * faces.places[k].z());
    cv.add_impulse(0, Vec3::Zero(), 1);
    EXPECT_NEAR((cv.state().impulse - Vec3(-8 * slope, 0, 0)).norm(), 0, 1e-5);
}

// Layers of particles that have sunk or risen by part of a spacing weigh what the pressure on the floor carries:
// counted whole, they would be up to half a layer too heavy or too light, rho g dp / 2 on the floor's area.
TEST(ControlVolume, WeighsLayersOfWaterAsTheFloorsPressureCarriesThem) {
    constexpr double dp = 0.1, floor = -1, edge = 0.8;
    ControlVolume::Shape half;
    half.mirrored = true;
    const ControlVolume cv({Vec3(-edge, 0, floor), Vec3(edge, edge, 1)}, dp, half);
    for (double risen = -0.45; risen < 0.5; risen += 0.1) {
        const double surface = risen * dp;
        double volume = 0;
        for (double x = -2; x < 2; x += dp)
            for (double y = dp / 2; y < 2; y += dp)
                for (double z = surface - dp / 2; z > -2; z -= dp) volume += dp * dp * dp * cv.share(x, y, z);
        EXPECT_NEAR(volume, 2 * edge * edge * (surface - floor), 1e-9) << risen;
    }
}

}  // namespace control_volume_test
}  // namespace tw::test

#include "motion/floating_attitude.h"

#include <cmath>
#include <functional>
#include <numbers>

#include "meshes/mass_properties.h"

namespace tw {
namespace {

constexpr double steepest = 20 * std::numbers::pi / 180;

/// A zero of `f` between two places where its signs differ, to `within`: false position, with the value at a place that
/// stays halved (Illinois; Dowell & Jarratt 1971, doi:10.1007/BF01934364).
std::optional<double> zero_between(const std::function<double(double)>& f, double a, double b, double within) {
    double fa = f(a), fb = f(b);
    if (!(fa * fb <= 0)) return {};
    for (int round = 0; round < 100 && std::abs(b - a) > within && fb != 0; ++round) {
        const double x = (a * fb - b * fa) / (fb - fa), fx = f(x);
        if (fx * fb <= 0)
            a = b, fa = fb;
        else
            fa /= 2;
        if (std::abs(x - b) < 0.1 * within) return x;
        b = x, fb = fx;
    }
    return b;
}

Surface moved(const Surface& surface, const Vec3& centre, double turn, double rise) {
    const Eigen::Matrix3d about_y = Eigen::AngleAxisd(turn, Vec3::UnitY()).toRotationMatrix();
    Surface result = surface;
    for (Vec3& p : result.points) p = centre + about_y * (p - centre) + Vec3(0, 0, rise);
    return result;
}

}  // namespace

std::optional<FloatingAttitude> floating_attitude(const Surface& surface, double volume, const Vec3& centre,
                                                  const DegreesOfFreedom& free) {
    if (!free.along[2]) return FloatingAttitude{};
    const double length = surface.bounds().size().maxCoeff(), within = 1e-9 * length;
    const auto rise_at = [&](double turn) {
        const Surface turned = moved(surface, centre, turn, 0);
        const Box box = turned.bounds();
        const auto excess = [&](double rise) { return hydrostatics(moved(turned, centre, 0, rise)).volume - volume; };
        return zero_between(excess, -box.max.z(), -box.min.z(), within);
    };
    const auto lever = [&](double turn) {
        const std::optional<double> rise = rise_at(turn);
        return rise ? hydrostatics(moved(surface, centre, turn, *rise)).centroid.x() - centre.x() : std::nan("");
    };
    FloatingAttitude at;
    if (free.about[1]) {
        const std::optional<double> turn = zero_between(lever, -steepest, steepest, 1e-8);
        if (!turn) return {};
        at.turn = *turn;
    }
    const std::optional<double> rise = rise_at(at.turn);
    if (!rise) return {};
    at.rise = *rise;
    return at;
}

}  // namespace tw

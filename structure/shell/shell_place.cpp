#include "structure/shell/shell_place.h"

#include <limits>

namespace tw::structure {

ShellPlace nearest_place(const Shell& shell, const Vec3& point) {
    ShellPlace place;
    place.distance = std::numeric_limits<double>::infinity();
    for (std::size_t e = 0; e < shell.elements().size(); ++e) {
        const Mitc4& element = shell.elements()[e];
        const Eigen::Vector2d within = element.coordinates(point).cwiseMax(-1).cwiseMin(1);
        const double distance = (element.place(within[0], within[1]) - point).norm();
        if (distance < place.distance) place = {static_cast<int>(e), within, distance};
    }
    return place;
}

}  // namespace tw::structure

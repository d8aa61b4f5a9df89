#include "structure/shell/gauge.h"

#include <fmt/format.h>

#include <cmath>

#include "base/errors.h"
#include "structure/shell/shell_place.h"

namespace tw::structure {

GaugeReader::GaugeReader(const Shell& shell, const Gauge& gauge) : shell_(&shell) {
    const ShellPlace place = nearest_place(shell, gauge.position);
    element_ = place.element;
    if (element_ < 0 || place.distance > shell.laminate().thickness())
        throw InputError(
            fmt::format("gauge {}: ({:.6g}, {:.6g}, {:.6g}) m is {:.3g} m from the shell; expected a place on it",
                        gauge.name, gauge.position.x(), gauge.position.y(), gauge.position.z(), place.distance));
    const Mitc4& element = shell.elements()[static_cast<std::size_t>(element_)];
    const Eigen::Vector2d n = (element.axes() * gauge.direction).head<2>();
    if (!(n.norm() > 1e-6 * gauge.direction.norm()))
        throw InputError(fmt::format("gauge {}: its direction stands across the shell", gauge.name));
    strains_ = element.strains(place.at[0], place.at[1]);
    const double c = n[0] / n.norm(), s = n[1] / n.norm(), z = (gauge.top ? 0.5 : -0.5) * shell.laminate().thickness();
    const Eigen::RowVector3d along(c * c, s * s, c * s);
    reading_ = along * (strains_.topRows<3>() + z * strains_.middleRows<3>(3));
}

double GaugeReader::strain(const Eigen::VectorXd& all) const { return reading_ * shell_->of_element(all, element_); }

PlyState GaugeReader::state(const Eigen::VectorXd& all, int ply, double height) const {
    return shell_->laminate().state(strains_ * shell_->of_element(all, element_), ply, height);
}

}  // namespace tw::structure

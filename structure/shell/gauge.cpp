#include "structure/shell/gauge.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "base/errors.h"

namespace tw::structure {

GaugeReader::GaugeReader(const Shell& shell, const Gauge& gauge) : shell_(&shell) {
    double nearest = std::numeric_limits<double>::max();
    Eigen::Vector2d at;
    for (std::size_t e = 0; e < shell.elements().size(); ++e) {
        const Mitc4& element = shell.elements()[e];
        const Eigen::Vector2d within = element.coordinates(gauge.position).cwiseMax(-1).cwiseMin(1);
        const double distance = (element.place(within[0], within[1]) - gauge.position).norm();
        if (distance < nearest) {
            nearest = distance;
            element_ = static_cast<int>(e);
            at = within;
        }
    }
    if (element_ < 0 || nearest > shell.laminate().thickness())
        throw InputError(
            fmt::format("gauge {}: ({:.6g}, {:.6g}, {:.6g}) m is {:.3g} m from the shell; expected a place on it",
                        gauge.name, gauge.position.x(), gauge.position.y(), gauge.position.z(), nearest));
    const Mitc4& element = shell.elements()[static_cast<std::size_t>(element_)];
    const Eigen::Vector2d n = (element.axes() * gauge.direction).head<2>();
    if (!(n.norm() > 1e-6 * gauge.direction.norm()))
        throw InputError(fmt::format("gauge {}: its direction stands across the shell", gauge.name));
    strains_ = element.strains(at[0], at[1]);
    const double c = n[0] / n.norm(), s = n[1] / n.norm(), z = (gauge.top ? 0.5 : -0.5) * shell.laminate().thickness();
    const Eigen::RowVector3d along(c * c, s * s, c * s);
    reading_ = along * (strains_.topRows<3>() + z * strains_.middleRows<3>(3));
}

double GaugeReader::strain(const Eigen::VectorXd& all) const { return reading_ * shell_->of_element(all, element_); }

PlyState GaugeReader::state(const Eigen::VectorXd& all, int ply, double height) const {
    return shell_->laminate().state(strains_ * shell_->of_element(all, element_), ply, height);
}

}  // namespace tw::structure

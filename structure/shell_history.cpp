#include "structure/shell_history.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "structure/shell/shell_place.h"
#include "structure/time/generalised_alpha.h"
#include "structure/time/nonlinear_alpha.h"

namespace tw::structure {
namespace {
using Eigen::VectorXd;

/// One shell and all that acts on it.
struct Case {
    const Shell& shell;
    const DegreesOfFreedom& dofs;
    const PressureHistory& pressure;
    const std::vector<GaugeReader>& gauges;
    const std::vector<ShellPlace>& points;
    const ShellConditions& conditions;

    VectorXd load(double t, const SparseMatrix& mass, const VectorXd& v) const {
        VectorXd f = dofs.widened(VectorXd(shell.pressure_load(pressure.at(t))));
        f += mass * dofs.translation(conditions.gravity);
        if (conditions.damping > 0) f -= conditions.damping * (mass * v);
        return f;
    }

    /// `strain`: of a gauge by the displacements of all degrees of freedom.
    template <class Integrator, class Strain>
    ShellHistory follow(Integrator& time, double dt, Strain strain) const {
        const SparseMatrix mass = dofs.mass(shell.mass()), basis = dofs.basis();
        ShellHistory out;
        out.strains.resize(gauges.size());
        out.displacements.resize(points.size());
        const double from = pressure.time.front();
        const auto steps = static_cast<long>(std::ceil((pressure.time.back() - from) / dt - 1e-9));
        for (long k = 0; k <= steps; ++k) {
            const double t = from + static_cast<double>(k) * dt;
            if (k > 0) time.step(load(t, mass, basis * time.state().v));
            const VectorXd u = time.displacement();
            out.time.push_back(t);
            for (std::size_t g = 0; g < gauges.size(); ++g) out.strains[g].push_back(strain(gauges[g], u));
            for (std::size_t p = 0; p < points.size(); ++p) {
                Vec3 moved = Vec3::Zero();
                const auto& corners = shell.mesh().quads[static_cast<std::size_t>(points[p].element)];
                for (std::size_t i = 0; i < 4; ++i) moved += points[p].shares()[i] * u.segment<3>(6 * corners[i]);
                out.displacements[p].push_back(moved);
            }
        }
        return out;
    }

    ShellHistory in_steps(double dt) const {
        const SparseMatrix mass = dofs.mass(shell.mass());
        const VectorXd v = dofs.translation(conditions.velocity), first = load(pressure.time.front(), mass, v);
        if (conditions.large_rotations) {
            NonlinearAlpha time(shell, dofs, dt);
            time.start(v, first);
            const Corotational elastic(shell);
            return follow(time, dt, [&](const GaugeReader& gauge, const VectorXd& u) {
                return gauge.strain(elastic.deformation(u.head(shell.dofs()), gauge.element()));
            });
        }
        GeneralisedAlpha time(dofs.widened(shell.stiffness()), mass, dofs.basis(), dt);
        time.start(VectorXd::Zero(dofs.all()), v, first);
        return follow(time, dt, [](const GaugeReader& gauge, const VectorXd& u) { return gauge.strain(u); });
    }
};

}  // namespace

VectorXd PressureHistory::at(double t) const {
    const auto after = static_cast<std::size_t>(std::ranges::upper_bound(time, t) - time.begin());
    if (after == 0) return pressure.front();
    if (after == time.size()) return pressure.back();
    const double share = (t - time[after - 1]) / (time[after] - time[after - 1]);
    return (1 - share) * pressure[after - 1] + share * pressure[after];
}

double PressureHistory::longest_gap() const {
    double longest = 0;
    for (std::size_t k = 1; k < time.size(); ++k) longest = std::max(longest, time[k] - time[k - 1]);
    return longest;
}

ShellHistory shell_history(const Shell& shell, const DegreesOfFreedom& dofs, const PressureHistory& pressure,
                           const std::vector<Gauge>& gauges, const std::vector<Vec3>& points,
                           const ShellConditions& conditions) {
    constexpr int most = 64;
    if (pressure.time.empty() || pressure.time.size() != pressure.pressure.size())
        throw InputError("the history of pressures has no times, or not as many as it has pressures");
    for (const VectorXd& p : pressure.pressure)
        if (p.size() != static_cast<Eigen::Index>(shell.elements().size()) || !p.allFinite())
            throw InputError(
                fmt::format("the history of pressures has {} values at a time, or one that is no number; "
                            "expected one for each of the {} elements",
                            p.size(), shell.elements().size()));
    if (!(conditions.step > 0 && std::isfinite(conditions.step)))
        throw InputError(fmt::format("time step {} s; expected a positive one", conditions.step));
    std::vector<GaugeReader> readers;
    for (const Gauge& gauge : gauges) readers.emplace_back(shell, gauge);
    std::vector<ShellPlace> places;
    for (const Vec3& point : points) places.push_back(nearest_place(shell, point));
    const Case of{shell, dofs, pressure, readers, places, conditions};
    for (int parts = 1;; parts *= 2) try {
            return of.in_steps(conditions.step / parts);
        } catch (const RunError&) {
            if (!conditions.large_rotations || parts == most) throw;
        }
}

}  // namespace tw::structure

#include "sph_solver/bodies/elastic/solid_in_time.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/errors.h"
#include "structure/solid/plane_contact.h"
#include "structure/solid/wet_surface.h"
#include "structure/time/central_difference.h"

namespace tw {
namespace {
using Eigen::VectorXd;

class SolidInTime : public StructureInTime {
public:
    explicit SolidInTime(const ElasticSetup& setup)
        : dofs_(setup.dofs),
          solid_(setup.solid()),
          surface_(solid_.solid, solid_.wet, solid_.start),
          carried_(solid_.solid.mesh().nodes.size()),
          time_(dofs_.mass(solid_.solid.mass()), dofs_.basis(),
                [this](const VectorXd& u, double) { return force(u); }) {
        if (!setup.gauges.empty()) throw InputError("strain gauges are glued to shells; a solid has none");
        for (const structure::RigidPart& part : dofs_.parts())
            for (const int n : part.nodes) carried_[static_cast<std::size_t>(n)] = true;
        if (solid_.floor) floor_.emplace(solid_.solid, solid_.wet, solid_.floor->height, solid_.floor->stiffness);
        time_.set_displacement(dofs_.widened(solid_.start));
        time_.set_velocity(setup.dofs.translation(setup.velocity));
        at_end_ = time_.displacement();
        shown_ = time_.velocity();
        const double own = 2 / solid_.solid.explicit_step(solid_.start),
                     of_floor = floor_ ? floor_->highest_frequency() : 0;
        longest_ = solid_.of_limit * 2 / std::hypot(own, of_floor);
        filled_at_start_ = filled(solid_.start);
    }

    const Surface& wetted_surface() const override { return surface_.closed(); }
    Tie tie(const Vec3& at_start) const override {
        const structure::WetSurface::Foot foot = surface_.foot(at_start);
        return {foot.nodes, foot.shares, foot.arm};
    }
    const std::vector<double>& wet_areas() const override { return surface_.areas(); }
    const VectorXd& mass() const override { return solid_.solid.mass(); }

    double step_within(double dt) const override { return dt; }
    VectorXd step(double kick, double drift, const VectorXd& load) override {
        const VectorXd before = time_.velocity();
        time_.add_impulse(kick * load);
        const VectorXd way = kick / 2 * (before + time_.velocity());
        const VectorXd found = time_.displacement();
        time_.advance(drift, longest_);
        at_end_ = time_.displacement();
        time_.advance(drift, longest_);
        shown_ = (time_.displacement() - found) / (2 * drift);
        return way;
    }
    VectorXd displacement() const override { return at_end_; }
    VectorXd velocity() const override { return shown_; }
    void place(double ahead, std::vector<Node>& nodes) const override {
        const VectorXd u = ahead > 0 ? time_.displacement() : at_end_;
        std::vector<Vec3> x = solid_.solid.mesh().nodes;
        for (std::size_t n = 0; n < x.size(); ++n) x[n] += u.segment<3>(static_cast<Eigen::Index>(3 * n));
        const std::vector<Eigen::Matrix3d> turns = surface_.turns(x);
        nodes.resize(x.size());
        for (std::size_t n = 0; n < x.size(); ++n)
            nodes[n] = {x[n], shown_.segment<3>(static_cast<Eigen::Index>(3 * n)),
                        carried_[n] ? Eigen::Matrix3d(Eigen::Matrix3d::Identity()) : turns[n]};
    }

    double kinetic_energy() const override { return time_.kinetic_energy(); }
    double elastic_energy() const override {
        const VectorXd u = of_nodes(time_.displacement());
        return solid_.solid.energy(u) - solid_.pressure * (filled(u) - filled_at_start_) +
               (floor_ ? floor_->energy(u) : 0);
    }
    double strain(std::size_t) const override { return 0; }
    double floor_force() const override { return floor_ ? floor_->total(of_nodes(at_end_)) : 0; }

    std::vector<double> state() const override {
        const structure::CentralDifference::State& s = time_.state();
        std::vector<double> all{s.t};
        for (const VectorXd* part : {&s.q, &s.v, &s.f, &at_end_, &shown_})
            all.insert(all.end(), part->begin(), part->end());
        return all;
    }
    void restore(std::span<const double> state) override {
        structure::CentralDifference::State s = time_.state();
        if (state.size() != static_cast<std::size_t>(1 + 3 * s.q.size() + 2 * shown_.size()))
            throw std::invalid_argument("another number of unknowns");
        s.t = state[0];
        std::size_t at = 1;
        for (VectorXd* part : {&s.q, &s.v, &s.f, &at_end_, &shown_}) {
            const auto size = static_cast<std::size_t>(part->size());
            std::ranges::copy(state.subspan(at, size), part->begin());
            at += size;
        }
        time_.set_state(std::move(s));
    }

private:
    VectorXd of_nodes(const VectorXd& all) const { return all.head(solid_.solid.dofs()); }

    VectorXd force(const VectorXd& all) const {
        const VectorXd u = of_nodes(all);
        VectorXd f = -solid_.solid.internal_force(u);
        if (solid_.pressure != 0) f += solid_.solid.pressure_load(u, solid_.pressed, solid_.pressure);
        if (floor_) f += floor_->force(u);
        return dofs_.widened(f);
    }
    /// Volume into which the surface `pressed` faces [m3]: a pressure's work is its product with this one's change.
    double filled(const VectorXd& u) const {
        if (solid_.pressure == 0) return 0;
        const VectorXd unit = solid_.solid.pressure_load(u, solid_.pressed, 1);
        double volume = 0;
        for (std::size_t n = 0; n < carried_.size(); ++n) {
            const auto first = static_cast<Eigen::Index>(3 * n);
            volume += unit.segment<3>(first).dot(solid_.solid.mesh().nodes[n] + u.segment<3>(first)) / 3;
        }
        return volume;
    }

    const structure::DegreesOfFreedom& dofs_;
    const ElasticSolid& solid_;
    structure::WetSurface surface_;
    std::vector<bool> carried_;
    std::optional<structure::PlaneContact> floor_;
    structure::CentralDifference time_;
    double longest_ = 0;  ///< sub-step [s]
    VectorXd at_end_;     ///< displacement at the end of the water's last step, of all degrees of freedom [m]
    VectorXd shown_;      ///< velocities that the water is shown, likewise [m/s]
    double filled_at_start_ = 0;
};

}  // namespace

std::unique_ptr<StructureInTime> solid_in_time(const ElasticSetup& setup) {
    return std::make_unique<SolidInTime>(setup);
}

}  // namespace tw

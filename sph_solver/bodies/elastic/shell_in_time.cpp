#include "sph_solver/bodies/elastic/shell_in_time.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <functional>
#include <stdexcept>

#include "base/errors.h"
#include "structure/shell/shell_place.h"
#include "structure/shell/skin.h"
#include "structure/time/generalised_alpha.h"
#include "structure/time/nonlinear_alpha.h"

namespace tw {
namespace {
using Eigen::VectorXd;

/// Integrators by their length of step, the last used first.
template <class Integrator>
class Steppers {
public:
    explicit Steppers(std::function<std::unique_ptr<Integrator>(double dt)> make) : make_(std::move(make)) {}

    Integrator& of(double dt) {
        constexpr std::size_t most = 6;
        auto at = std::ranges::find(known_, dt, &Known::first);
        if (at == known_.end()) {
            if (known_.size() == most) known_.pop_back();
            at = known_.emplace(known_.end(), dt, make_(dt));
        }
        std::rotate(known_.begin(), at, at + 1);
        return *known_.front().second;
    }

private:
    using Known = std::pair<double, std::unique_ptr<Integrator>>;
    std::function<std::unique_ptr<Integrator>(double dt)> make_;
    std::vector<Known> known_;
};

std::vector<double> joined(std::initializer_list<const VectorXd*> parts) {
    std::vector<double> all;
    for (const VectorXd* part : parts) all.insert(all.end(), part->begin(), part->end());
    return all;
}

void split(std::span<const double> all, std::initializer_list<VectorXd*> parts) {
    std::size_t at = 0;
    for (VectorXd* part : parts) {
        const auto size = static_cast<std::size_t>(part->size());
        if (at + size > all.size()) throw std::invalid_argument("too few numbers");
        std::ranges::copy(all.subspan(at, size), part->begin());
        at += size;
    }
    if (at != all.size()) throw std::invalid_argument("too many numbers");
}

Eigen::Matrix3d turn_by(const Vec3& rotation) {
    const double angle = rotation.norm();
    if (angle == 0) return Eigen::Matrix3d::Identity();
    return Eigen::AngleAxisd(angle, rotation / angle).toRotationMatrix();
}

/// Area of the shell about each node [m2].
std::vector<double> node_areas(const structure::Shell& shell) {
    std::vector<double> areas(shell.mesh().nodes.size(), 0.0);
    for (std::size_t e = 0; e < shell.elements().size(); ++e)
        for (std::size_t i = 0; i < 4; ++i)
            areas[static_cast<std::size_t>(shell.mesh().quads[e][i])] +=
                shell.elements()[e].node_area()[static_cast<int>(i)];
    return areas;
}

/// What the two kinds of shell have in common.
class ShellInTime : public StructureInTime {
public:
    explicit ShellInTime(const ElasticSetup& setup)
        : shell_(setup.shell().shell),
          wetted_(structure::Skin(shell_, setup.shell().skin).reference()),
          areas_(node_areas(shell_)) {
        for (const structure::Gauge& gauge : setup.gauges) gauges_.emplace_back(shell_, gauge);
    }

    const Surface& wetted_surface() const override { return wetted_; }
    const std::vector<double>& wet_areas() const override { return areas_; }
    const VectorXd& mass() const override { return shell_.mass(); }
    double step_within(double dt) const override { return std::exp2(std::floor(4 * std::log2(dt)) / 4); }

    Tie tie(const Vec3& at_start) const override {
        const structure::ShellPlace place = structure::nearest_place(shell_, at_start);
        Tie tie;
        tie.nodes = shell_.mesh().quads[static_cast<std::size_t>(place.element)];
        tie.shares = place.shares();
        tie.arm = at_start;
        for (std::size_t i = 0; i < 4; ++i)
            tie.arm -= tie.shares[i] * shell_.mesh().nodes[static_cast<std::size_t>(tie.nodes[i])];
        return tie;
    }

    void place(double ahead, std::vector<Node>& nodes) const override {
        const VectorXd u = displacement(), v = velocity();
        nodes.resize(shell_.mesh().nodes.size());
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            const auto first = static_cast<Eigen::Index>(6 * k);
            Node& n = nodes[k];
            n.v = v.segment<3>(first);
            n.x = shell_.mesh().nodes[k] + u.segment<3>(first) + ahead * n.v;
            n.R = turn_by(ahead * v.segment<3>(first + 3)) * turn_by(u.segment<3>(first + 3));
        }
    }

protected:
    const structure::Shell& shell_;
    std::vector<structure::GaugeReader> gauges_;

private:
    Surface wetted_;
    std::vector<double> areas_;
};

/// Any length serves where nothing is stepped.
constexpr double no_step = 1;

class LinearShell : public ShellInTime {
public:
    using Integrator = structure::GeneralisedAlpha;

    explicit LinearShell(const ElasticSetup& setup)
        : ShellInTime(setup),
          basis_(setup.dofs.basis()),
          K_(setup.dofs.widened(shell_.stiffness())),
          M_(setup.dofs.mass(shell_.mass())),
          steppers_([this, kept = setup.shell().kept](double dt) {
              return std::make_unique<Integrator>(K_, M_, basis_, dt, kept);
          }) {
        Integrator& any = steppers_.of(no_step);
        const VectorXd none = VectorXd::Zero(setup.dofs.all());
        any.start(none, setup.dofs.translation(setup.velocity), none);
        state_ = any.state();
    }

    VectorXd step(double dt, double, const VectorXd& load) override {
        Integrator& time = steppers_.of(dt);
        const VectorXd before = displacement();
        state_.f = basis_.transpose() * load;
        time.set_state(state_);
        time.step(load);
        state_ = time.state();
        return displacement() - before;
    }
    VectorXd displacement() const override { return basis_ * state_.q; }
    VectorXd velocity() const override { return basis_ * state_.v; }
    double kinetic_energy() const override {
        const VectorXd v = velocity();
        return v.dot(M_ * v) / 2;
    }
    double elastic_energy() const override {
        const VectorXd u = displacement();
        return u.dot(K_ * u) / 2;
    }
    double strain(std::size_t gauge) const override { return gauges_[gauge].strain(displacement()); }
    std::vector<double> state() const override { return joined({&state_.q, &state_.v, &state_.a}); }
    void restore(std::span<const double> state) override { split(state, {&state_.q, &state_.v, &state_.a}); }

private:
    structure::SparseMatrix basis_, K_, M_;
    Steppers<Integrator> steppers_;
    Integrator::State state_;
};

class TurningShell : public ShellInTime {
public:
    using Integrator = structure::NonlinearAlpha;

    explicit TurningShell(const ElasticSetup& setup)
        : ShellInTime(setup),
          elastic_(shell_),
          basis_(setup.dofs.basis()),
          M_(setup.dofs.mass(shell_.mass())),
          steppers_([this, &setup](double dt) { return std::make_unique<Integrator>(shell_, setup.dofs, dt); }) {
        Integrator& any = steppers_.of(no_step);
        any.start(setup.dofs.translation(setup.velocity), VectorXd::Zero(setup.dofs.all()));
        state_ = any.state();
    }

    VectorXd step(double dt, double, const VectorXd& load) override {
        constexpr int most = 256;
        state_.f = basis_.transpose() * load;
        const Integrator::State start = state_;
        for (;; parts_ *= 2) try {
                return step_in_parts(dt, load);
            } catch (const RunError&) {
                if (parts_ == most) throw;
                state_ = start;
            }
    }
    VectorXd displacement() const override { return state_.u; }
    VectorXd velocity() const override { return basis_ * state_.v; }
    double kinetic_energy() const override {
        const VectorXd v = velocity();
        return v.dot(M_ * v) / 2;
    }
    double elastic_energy() const override { return elastic_.energy(state_.u.head(shell_.dofs())); }
    double strain(std::size_t gauge) const override {
        const structure::GaugeReader& of = gauges_[gauge];
        return of.strain(elastic_.deformation(state_.u.head(shell_.dofs()), of.element()));
    }
    std::vector<double> state() const override {
        const VectorXd parts = VectorXd::Constant(1, parts_);
        return joined({&parts, &state_.u, &state_.v, &state_.a, &state_.F});
    }
    void restore(std::span<const double> state) override {
        VectorXd parts(1);
        split(state, {&parts, &state_.u, &state_.v, &state_.a, &state_.F});
        parts_ = static_cast<int>(parts[0]);
    }

private:
    VectorXd step_in_parts(double dt, const VectorXd& load) {
        constexpr int easy = 12;  // iterations
        Integrator& time = steppers_.of(dt / parts_);
        VectorXd change = VectorXd::Zero(state_.v.size());
        int hardest = 0;
        for (int part = 0; part < parts_; ++part) {
            const VectorXd before = state_.v;
            time.set_state(state_);
            hardest = std::max(hardest, time.step(load));
            state_ = time.state();
            change += dt / parts_ / 2 * (before + state_.v);
        }
        if (hardest <= easy && parts_ > 1) parts_ /= 2;
        return basis_ * change;
    }

    structure::Corotational elastic_;
    structure::SparseMatrix basis_, M_;
    Steppers<Integrator> steppers_;
    Integrator::State state_;
    int parts_ = 1;  ///< of a step
};

}  // namespace

std::unique_ptr<StructureInTime> linear_shell(const ElasticSetup& setup) {
    return std::make_unique<LinearShell>(setup);
}
std::unique_ptr<StructureInTime> turning_shell(const ElasticSetup& setup) {
    return std::make_unique<TurningShell>(setup);
}

}  // namespace tw

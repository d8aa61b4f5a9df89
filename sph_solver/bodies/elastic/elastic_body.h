#pragma once
#include <cmath>
#include <memory>
#include <span>
#include <vector>

#include "sph_solver/bodies/body.h"
#include "sph_solver/bodies/elastic/dof_sums.h"
#include "sph_solver/bodies/elastic/elastic_setup.h"
#include "sph_solver/bodies/elastic/structure_in_time.h"
#include "sph_solver/bodies/elastic/tie.h"

namespace tw {

/// A shell or a solid in the water: how it moves under what its dummies hand to it, and how they follow it.
///
/// A point of the body hangs on the foot of its perpendicular on the shell, or on the wet faces of the solid, with the
/// foot's shares N of the element's four nodes and an arm r, so that
///
///   x = sum_n N_n (X_n + u_n + R_n r),   v = sum_n N_n v_n
///   f_n += N_n F                                                       what a force F on the point does to the nodes
///
/// The last is the transpose of the velocity, so force and power pass over to rounding. R_n is the node's turn: a
/// shell's own, a solid's by the faces about it. The arm stands across the shell: what a turn adds to v is along it,
/// where walls let water slip, and a moment is left out only of forces along it. Both would come from the surface,
/// which may be many times thicker than the shell: its arms bent a thin plate.
///
/// A step is cut where the water's is. The structure stands at the begin of a step while the water looks half a step
/// ahead (`look_ahead`: shells with their present velocities, solids where they will be); the forces found there act
/// through the whole step of a shell (shell_in_time.h), and as an impulse in its middle on a solid (solid_in_time.h).
///
/// Added mass: as of rigid bodies (bodies/rigid_in_water.h) water answers to a wall's acceleration within the same
/// evaluation, with the mass of 0.62 dp of water where h = 1.55 dp (docs/decisions/038-coupling.md). So each node hands
/// over a relaxed acceleration,
///
///   a'_n += theta_n (a_n - a'_n),   theta_n = 1 / (1 + rho0 dp A_n / m_n)
///
/// A_n the area about the node and m_n its mass, or those of all nodes that a rigid part carries.
class ElasticBody : public Body {
public:
    explicit ElasticBody(BodySetup setup);

    const ElasticSetup& setup() const { return *setup_; }
    bool fixed() const override { return false; }
    bool is_deformable() const override { return true; }
    bool meets_wall(const Vec3& normal) const override;

    // --- points of the body
    Tie tie(const Vec3& at_start) const;
    Vec3 place(const Tie& tie) const;         ///< now, or as far as was looked ahead [m]
    Vec3 velocity(const Tie& tie) const;      ///< [m/s]
    Vec3 acceleration(const Tie& tie) const;  ///< relaxed [m/s2]

    Dummies dummies(const DummyLattice& lattice) const override;
    std::unique_ptr<Attached> attach(std::vector<Vec3> at_start) const override;

    // --- the closed surface
    Vec3 now(const Vec3& x) const override { return place(tie(x)); }
    /// Where a place near the surface was when that was noted.
    Vec3 at_start(const Vec3& x) const override;
    Surface surface_now(std::optional<double> span = {}) const override;
    void note_surface() override;
    const SurfaceQuery& query() const override { return *noted_query_; }
    /// Velocity of the surface by the place `x` on or near a triangle of it (-1: none) [m/s].
    Vec3 velocity_on(int triangle, const Vec3& x) const;
    Attached::WettedSurface wetted_surface() const { return {corners_, noted_, surface_velocity_, times_noted_}; }
    double fastest() const;  ///< speed of a point of the surface [m/s]

    // --- time
    void meet(const WaterNear& water, const Dummies& dummies) override;
    /// Water on a wall is a spring of rho0 c0^2 / dp to a unit of area; below 2 / omega of the lightest node on it [s].
    double stable_step() const override;
    double step_within(double dt) const override { return structure_->step_within(dt); }
    int sub_iterations() const override { return setup_->coupling.iterations - 1; }

    void look_ahead(double drift) override;
    bool takes_forces_of_dummies() const override { return true; }
    void take(const Load& /*load*/) override {}
    void take(const Attached& dummies, const std::vector<Vec3>& forces) override;
    void take(const WallPush& push) override;
    bool presses() const override { return setup_->coupling.interface->presses(); }
    double pressing(double distance, double dp) const override {
        return setup_->coupling.interface->pressing(distance, dp);
    }
    void take_impulse(const Impulse& /*all*/) override {}
    void take_impulse(const WallImpulse& place) override;
    /// Makes the step that `move` would make, takes it back, and hands over the relaxed acceleration that it had: the
    /// forces on the body are then found anew. So water and body answer each other again within one step; each time the
    /// error of that acceleration falls by 1 - theta (1 + c rho0 dp A/m), see above.
    void sub_iterate(const BodyStep& step) override;
    /// The water has been compressed with the velocities that the dummies had till now for twice what was drifted
    /// before; what will be drifted at the end is how far the next evaluation looks ahead.
    void move(const BodyStep& step) override;

    // --- what is recorded; energies of the whole width [J]
    bool in_plane() const { return setup_->width > 0; }
    double width() const { return in_plane() ? setup_->width : 1; }
    double kinetic_energy() const { return structure_->kinetic_energy(); }
    double elastic_energy() const { return structure_->elastic_energy(); }
    /// Work of the water on the structure so far, on both sides of the interface: taken, f . (u' - u) of each step, and
    /// given, F_j . v_j over the time in which the water felt the dummies' velocities v_j, with the mean of the forces
    /// before and after. Their difference is the energy that the interface makes or loses.
    double work_taken() const { return work_taken_; }
    double work_given() const { return work_given_; }
    double work_exchanged() const { return work_exchanged_; }  ///< the sum of the magnitudes, step by step
    /// The same over the last sixteen steps or so, over the work exchanged in them or, if larger, a hundredth of all:
    /// water and body that throw their accelerations to and fro (added mass) make as much energy as they exchange [-].
    std::optional<double> energy_made_lately() const override;
    /// Its first rigid part where it has one, the water's force, its points and gauges, and energies.
    void describe(const Load& load, const Note& note) const override;
    bool knows_its_work() const override { return true; }
    double floor_force() const { return structure_->floor_force(); }  ///< of a rigid floor that it meets, upward [N]
    const Vec3& impulse() const { return impulse_; }                  ///< of the water's forces so far [N s]
    Vec3 deflection(std::size_t point) const;                         ///< [m]
    double strain(std::size_t gauge) const;                           ///< [-]
    /// Of a rigid part, or of node sets alike: displacement, velocity and, over the last step, acceleration.
    struct PartMotion {
        Vec3 displacement, velocity, acceleration;  ///< [m], [m/s], [m/s2]
    };
    PartMotion part(std::size_t part) const;

    std::vector<double> state() const override;
    void restore(std::span<const double> state) override;

private:
    void note_nodes(double ahead);
    SurfaceMotion surface_motion() const { return {corners_.data(), noted_.data(), surface_velocity_.data()}; }
    Vec3 barycentric(int triangle, const Vec3& x) const;
    void relax(const Eigen::VectorXd& acceleration);
    void push(const Tie& tie, const Vec3& force);
    /// With the body's own weight, or what it feels in a tank that moves, and its damping, in the middle of the step.
    Eigen::VectorXd load_of(const Eigen::VectorXd& water, const BodyStep& step) const;
    void add_weight(Eigen::VectorXd& load, double ahead) const;
    /// Of a node's degrees of freedom.
    Eigen::Index first_of(std::size_t node) const { return static_cast<Eigen::Index>(node) * setup_->dofs.per_node(); }

    std::shared_ptr<const ElasticSetup> setup_;
    std::unique_ptr<StructureInTime> structure_;
    std::vector<Tie> points_;

    Surface wetted_;                 ///< at the start
    std::vector<Tie> surface_ties_;  ///< of its points
    std::vector<Corners> corners_;  ///< of its triangles
    std::vector<Vec3> surface_at_;
    std::vector<V3<double>> surface_velocity_, noted_;
    std::int64_t times_noted_ = 0;
    std::unique_ptr<SurfaceQuery> noted_query_;
    bool moved_since_noted_ = false;

    std::vector<StructureInTime::Node> nodes_;
    Eigen::VectorXd u_, v_;              ///< of all degrees of freedom
    Eigen::VectorXd accelerations_;      ///< relaxed, three for each node
    Eigen::VectorXd last_acceleration_;  ///< of all degrees of freedom, over the last step
    DofSums force_, impulses_;           ///< that wait for `move`, of all degrees of freedom
    ExactSum power_;                     ///< of the forces in force_, with the velocities that the water felt [W]
    double power_before_ = 0;            ///< of the forces before, with the same velocities [W]
    std::vector<double> relaxation_;     ///< theta of each node
    double time_ = 0;                    ///< at which the structure stands [s]
    double lightest_ = 0;                ///< the largest rho0 dp A / m of a node that may move [-]
    WaterNear water_;
    double interface_step_ = HUGE_VAL;  ///< what the interface allows [s]
    double work_taken_ = 0, work_given_ = 0, work_exchanged_ = 0;
    double made_lately_ = 0, exchanged_lately_ = 0;  ///< [J]
    Vec3 impulse_ = Vec3::Zero();
};

}  // namespace tw

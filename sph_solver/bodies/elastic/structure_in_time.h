#pragma once
#include <memory>
#include <span>
#include <vector>

#include "meshes/surface.h"
#include "sph_solver/bodies/elastic/elastic_setup.h"
#include "sph_solver/bodies/elastic/tie.h"

namespace tw {

/// An elastic structure as the coupling knows it (elastic_body.h): the surface that the water sees, how points hang on
/// the nodes, and how the nodes get over a step of the water under the load that acts through it. Shells are stepped
/// implicitly (shell_in_time.h), solids explicitly by sub-steps (solid_in_time.h).
class StructureInTime {
public:
    virtual ~StructureInTime() = default;

    // --- at the start
    virtual const Surface& wetted_surface() const = 0;  ///< closed, triangles outward [m]
    virtual Tie tie(const Vec3& at_start) const = 0;
    virtual const std::vector<double>& wet_areas() const = 0;  ///< of the surface about each node [m2]
    virtual const Eigen::VectorXd& mass() const = 0;           ///< lumped, by degree of freedom [kg], [kg m2]

    // --- time
    /// The step of the water that the structure takes where `dt` is allowed [s].
    virtual double step_within(double dt) const = 0;
    /// Through a step of the water: `load` on all degrees of freedom [N], [N m], which the water has found where the
    /// structure looked ahead to, acts for `kick`; the water finds the next `drift` after the step's end [s]. Returns
    /// the way of all degrees of freedom under the load, turns as the sum of small ones, so that its product with the
    /// load is the load's work. Throws RunError where the step cannot be made.
    virtual Eigen::VectorXd step(double kick, double drift, const Eigen::VectorXd& load) = 0;
    /// Of all degrees of freedom: [m] and rotation vectors since the mesh's places; [m/s] and spins, as the water is
    /// shown them.
    virtual Eigen::VectorXd displacement() const = 0;
    virtual Eigen::VectorXd velocity() const = 0;
    struct Node {
        Vec3 x, v;          ///< [m], [m/s]
        Eigen::Matrix3d R;  ///< turn since the start
    };
    /// The nodes a time `ahead` from the end of the last step, 0 or its `drift` [s].
    virtual void place(double ahead, std::vector<Node>& nodes) const = 0;

    virtual double kinetic_energy() const = 0;  ///< [J]
    virtual double elastic_energy() const = 0;  ///< [J], with that of pressures and contacts
    virtual double strain(std::size_t gauge) const = 0;
    virtual double floor_force() const { return 0; }  ///< that a rigid floor pushes up with [N]

    /// All that changes, for a restart that goes on to the same bits.
    virtual std::vector<double> state() const = 0;
    /// Throws std::invalid_argument for numbers that are those of no state of this structure.
    virtual void restore(std::span<const double> state) = 0;
};

/// `setup` must outlive it.
std::unique_ptr<StructureInTime> structure_in_time(const ElasticSetup& setup);
/// The surface that the water sees at the start.
Surface wetted_surface_of(const ElasticSetup& setup);

}  // namespace tw

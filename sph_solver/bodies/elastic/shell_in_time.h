#pragma once
#include <memory>
#include <span>
#include <vector>

#include "sph_solver/bodies/elastic/elastic_setup.h"

namespace tw {

/// A shell advanced by steps of any length, each under a load that acts in its middle:
///
///   M (v' - v)/dt + F((u + u')/2) = f,   u' - u = dt (v + v')/2
///
/// (average acceleration with f at both ends of the step; structure/time). The work of a load over a step is
/// f . (u' - u), and the energy of shell and load is conserved: exactly where F is linear. A length of step costs one
/// factorisation, and the last few are kept. At large rotations a step that does not balance is made of equal parts,
/// under the same load: twice as many as the step before, and half as many again where balancing has become easy.
class ShellInTime {
public:
    virtual ~ShellInTime() = default;

    /// `load`: on all freedoms [N], [N m]. Returns u' - u of all freedoms, turns as the sum of small ones, so that its
    /// product with a load is the load's work. Throws RunError where 256 parts of a step do not balance.
    virtual Eigen::VectorXd step(double dt, const Eigen::VectorXd& load) = 0;
    /// Of all freedoms: [m] and rotation vectors, [m/s] and spins.
    virtual Eigen::VectorXd displacement() const = 0;
    virtual Eigen::VectorXd velocity() const = 0;
    virtual double kinetic_energy() const = 0;  ///< [J]
    virtual double elastic_energy() const = 0;  ///< [J]
    virtual double strain(const structure::GaugeReader& gauge) const = 0;

    /// All that changes, for a restart that goes on to the same bits.
    virtual std::vector<double> state() const = 0;
    /// Throws std::invalid_argument for numbers that are those of no state of this shell.
    virtual void restore(std::span<const double> state) = 0;
};

/// `setup` must outlive it.
std::unique_ptr<ShellInTime> linear_shell(const ElasticSetup& setup);
std::unique_ptr<ShellInTime> turning_shell(const ElasticSetup& setup);

}  // namespace tw

#pragma once
#include <cmath>
#include <memory>

#include "sph_solver/bodies/dummies.h"

namespace tw {

class ElasticBody;
struct ElasticPlate;

/// How water and an elastic body act on each other. Each kind is one file; interfaces.cpp lists them.
class WaterInterface {
public:
    virtual ~WaterInterface() = default;
    /// What the kernels of the water see of the body.
    virtual Dummies dummies(const ElasticBody& body, const DummyLattice& lattice) const = 0;
    /// Whether it presses on particles beside what dummies do, and with what force along the surface's normal where one
    /// is `distance` off the surface [N].
    virtual bool presses() const { return false; }
    virtual double pressing(double /*distance*/, double /*dp*/) const { return 0; }
    /// What that force allows [s]. `lightest`: the largest mass of a spacing of water on a node over the node's own.
    virtual double stable_step(double /*rho0*/, double /*dp*/, double /*lightest*/) const { return HUGE_VAL; }
};

using Interface = std::shared_ptr<const WaterInterface>;

/// By dummies that carry the pressure of the water near, as rigid walls do; no free parameter.
Interface pressure_interface();
/// By the nodes of the wet faces as particles that the water alone sees, with its pressure.
Interface background_interface();

/// By contact forces on particles nearer than half a spacing, as codes of crash analysis couple SPH and finite elements
/// (Jian & Wu's study, eq. 7: F_i = SLFACM STF g_i); the kernel sees no body. How the force F grows with the
/// penetration g, over k g, where `s = g / (dp/2)`:
struct PenaltyContact {
    enum class Law {
        linear,     ///< 1
        nonlinear,  ///< 1 / (1 - s), for s up to 0.95: nothing gets through
        adaptive    ///< 1 + (s / 0.1)^2: stiff enough to keep the penetration near a tenth of the reach
    } law = Law::linear;
    double factor = 0.01;  ///< of the stiffness k = factor K dp, K the bulk modulus of real water [-]
};
Interface penalty_interface(const PenaltyContact& contact);

/// The one that a scene names.
Interface interface_of(const ElasticPlate& plate);

/// How a body and its interface are advanced in time.
struct Coupling {
    Interface interface = pressure_interface();
    /// How often water and body answer each other in each step (ElasticBody::sub_iterate).
    int iterations = 1;
    /// Whether the water feels relaxed accelerations (elastic_body.h). Without it the scheme is the conventional
    /// staggered one, which a body lighter than the water that moves with it makes unstable.
    bool relaxed = true;
};

}  // namespace tw

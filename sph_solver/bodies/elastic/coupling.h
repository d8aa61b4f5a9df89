#pragma once

namespace tw {

/// How water and an elastic body act on each other.
struct Coupling {
    enum class Kind {
        pressure,  ///< by dummies that carry the pressure of the water near, as rigid walls do; no free parameter
        penalty,  ///< by contact forces on particles nearer than `reach()` (penalty_contact.h); the kernel sees no body
        background  ///< by the nodes of the wet faces as particles that the water alone sees, with its pressure
    } kind = Kind::pressure;

    /// How often water and body answer each other in each step (ElasticBody::rehearse).
    int iterations = 1;
    /// Whether the water feels relaxed accelerations (elastic_body.h). Without it the scheme is the conventional staggered
    /// one, which a body lighter than the water that moves with it makes unstable.
    bool relaxed = true;

    // of penalty alone
    /// How the force F grows with the penetration g, over k g, where `s = g / reach`:
    enum class Law {
        linear,     ///< 1
        nonlinear,  ///< 1 / (1 - s), for s up to 0.95: nothing gets through
        adaptive    ///< 1 + (s / 0.1)^2: stiff enough to keep the penetration near a tenth of the reach
    } law = Law::linear;
    double factor = 0.01;  ///< of the stiffness k = factor K dp, K the bulk modulus of real water

    static constexpr double bulk_modulus = 2.19e9;                            ///< [Pa], 1000 kg/m3 (1480 m/s)^2
    double stiffness(double dp) const { return factor * bulk_modulus * dp; }  ///< of one particle's contact [N/m]
    static constexpr double reach(double dp) { return dp / 2; }               ///< particles of a lattice just touch [m]
    /// Force of a contact with the penetration `g` [N], none where there is none.
    double force(double g, double dp) const {
        if (g <= 0) return 0;
        const double s = g / reach(dp);
        const double growth = law == Law::linear      ? 1
                              : law == Law::nonlinear ? 1 / (1 - (s < 0.95 ? s : 0.95))
                                                      : 1 + 100 * s * s;
        return stiffness(dp) * g * growth;
    }
    /// dF/dg over k that the time step allows for, with a factor of four to spare: that of half the reach where the law
    /// is nonlinear, of a tenth where it is adaptive.
    double steepness() const { return law == Law::linear ? 1 : 4; }
};

}  // namespace tw

#include <algorithm>

#include "sph_solver/bodies/elastic/elastic_body.h"
#include "sph_solver/bodies/elastic/interface.h"

namespace tw {
namespace {

class PenaltyInterface : public WaterInterface {
public:
    explicit PenaltyInterface(const PenaltyContact& contact) : contact_(contact) {}

    /// Without volume: where the body is near is found by them.
    Dummies dummies(const ElasticBody& body, const DummyLattice& lattice) const override {
        Dummies d = body.Body::dummies(lattice);
        std::ranges::fill(d.volumes, 0.0);
        return d;
    }
    bool presses() const override { return true; }
    double pressing(double distance, double dp) const override {
        const double reach = dp / 2, g = reach - distance;  // particles of a lattice just touch
        if (g <= 0) return 0;
        const double s = g / reach;
        const double growth = contact_.law == PenaltyContact::Law::linear      ? 1
                              : contact_.law == PenaltyContact::Law::nonlinear ? 1 / (1 - (s < 0.95 ? s : 0.95))
                                                                               : 1 + 100 * s * s;
        return stiffness(dp) * g * growth;
    }
    /// 1 / omega of a particle and of the lightest node on the contact, with a factor of four to spare: for the
    /// steepness of half the reach where the law is nonlinear, of a tenth where it is adaptive.
    double stable_step(double rho0, double dp, double lightest) const override {
        const double steepness = contact_.law == PenaltyContact::Law::linear ? 1 : 4;
        return 1 / std::sqrt(steepness * stiffness(dp) / (rho0 * dp * dp * dp) * (1 + lightest));
    }

private:
    static constexpr double bulk_modulus = 2.19e9;  ///< [Pa], 1000 kg/m3 (1480 m/s)^2
    double stiffness(double dp) const { return contact_.factor * bulk_modulus * dp; }  ///< of one contact [N/m]
    PenaltyContact contact_;
};

}  // namespace

Interface penalty_interface(const PenaltyContact& contact) { return std::make_shared<PenaltyInterface>(contact); }

}  // namespace tw

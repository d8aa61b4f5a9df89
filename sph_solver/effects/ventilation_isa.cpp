// The sweep of ventilation, once per variant.
#include "sph_solver/effects/ventilation.h"
#include "sph_solver/sweeps/sweep.h"

namespace tw {
namespace TW_ISA {
namespace {

struct NearAir {
    const NearAirData& d;
    Real touched{};

    NearAir(const NearAirData& data, const Own&) : d(data) {}
    void sums(auto&& of) { of(touched); }
    ListRef list(const Group&) const { return {}; }
    void meet(std::int32_t, const Met&) {}
    void meet_at_surface(const Met& ij) { touched += ij.V_W(); }
    void store(const Own& i) const {
        i.for_each([&](int own, int l) { d.near[own] = touched[l] > 0; });
    }
};

}  // namespace

template <>
void pass(const NearAirData& d, const Group* groups, int count) {
    run<NearAir>(d, groups, count);
}

}  // namespace TW_ISA
}  // namespace tw

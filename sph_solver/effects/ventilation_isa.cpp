// The pair loop of ventilation, once per variant.
#include "sph_solver/effects/ventilation.h"
#include "sph_solver/loops/surface.h"
#include "sph_solver/pair_loops/pair_loop.h"

namespace tw {
namespace TW_ISA {
namespace {

struct NearAir {
    const NearAirData& d;
    Real air{}, drho{};

    NearAir(const NearAirData& data, const Own&) : d(data) {}
    void sums(auto&& of) { of(air), of(drho); }
    void meet(std::int32_t j, const Met& ij) {
        if (!marked(d.water.surface, static_cast<std::size_t>(j))) drho += d.water.motion[j].drho * ij.V_W();
    }
    void meet_at_surface(const Met& ij) { air += ij.V_W(); }
    void store(const Own& i) const {
        i.for_each([&](int own, int l) {
            d.round[own] = !(air[l] > 0) ? Round::no_air : drho[l] > 0 ? Round::air : Round::air_and_tension;
        });
    }
};

}  // namespace

template <>
void pass(const NearAirData& d, const Cluster* clusters, int count) {
    run<NearAir>(d, clusters, count);
}

}  // namespace TW_ISA
}  // namespace tw

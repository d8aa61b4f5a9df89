// The table of one variant's pair loops.
#include "sph_solver/pair_loops/passes.h"

namespace tw {
namespace TW_ISA {

template <class View>
void pass(const View&, const Cluster*, int count);
ClusterReach reach_of(const PackedPlace* places, const Cluster& g, const Reaches& reaches);
Reached reached(const ClusterReach& g, const PackedPlace* first, const PackedPlace* end, int count, std::int64_t top);

namespace {

template <class... Views>
constexpr PassTable<Views...> filled(PassTable<Views...>) {
    return {Pass<Views>{pass<Views>}...};
}

}  // namespace

extern const Passes table;
constinit const Passes table{.isa = TW_ISA_NAME,
                             .lanes = TW_LANES,
                             .engine = filled(EnginePairLoops{}),
#ifdef TW_WITHOUT_EFFECTS
                             .effects = {},
#else
                             .effects = filled(EffectPairLoops{}),
#endif
                             .reach_of = reach_of,
                             .reached = reached};

}  // namespace TW_ISA
}  // namespace tw

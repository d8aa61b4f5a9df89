#include <cstdlib>
#include <string>

#include "base/errors.h"
#include "sph_solver/backend/variants.h"

namespace tw {

// TW_VARIANTS: variant(NAME, LEVEL) for each one, see the list in sph_solver/CMakeLists.txt.
#define variant(name, level)   \
    namespace name {           \
    extern const Passes table; \
    }
TW_VARIANTS
#undef variant

namespace {

struct Variant {
    const Passes& passes;
    int level;  ///< of the instruction set, x86-64-v...; 0: any processor; by_name: any, where it is asked for by name
};
constexpr int by_name = -1;
/// Better instruction sets first, and of each the default first.
#define variant(name, level) {name::table, level},
const Variant variants[] = {TW_VARIANTS};
#undef variant

int level_of_this_processor() {
#ifdef __x86_64__
    if (__builtin_cpu_supports("x86-64-v4")) return 4;
    if (__builtin_cpu_supports("x86-64-v3")) return 3;
#endif
    return 0;
}

}  // namespace

std::vector<const Passes*> runnable_passes() {
    std::vector<const Passes*> runnable;
    for (const Variant& v : variants)
        if (v.level <= level_of_this_processor()) runnable.push_back(&v.passes);
    return runnable;
}

std::vector<const Passes*> passes_to_choose_from() {
    std::vector<const Passes*> best;
    for (const Variant& v : variants)
        if (v.level == level_of_this_processor()) best.push_back(&v.passes);
    return best;
}

const Passes& passes(const char* isa) {
    std::string known;
    for (const Passes* p : runnable_passes()) {
        if (std::string(isa) == p->isa) return *p;
        known += std::string(known.empty() ? "" : ", ") + p->isa;
    }
    throw InputError("instruction set " + std::string(isa) +
                     ": not known or not supported by this processor; it runs: " + known);
}

const Passes* passes_asked_for() {
    const char* name = std::getenv("TWINWAKE_ISA");
    if (!name || !*name) return nullptr;
    return std::string(name) == "default" ? runnable_passes().front() : &passes(name);
}

const Passes& passes() {
    const Passes* asked = passes_asked_for();
    return asked ? *asked : *runnable_passes().front();
}

}  // namespace tw

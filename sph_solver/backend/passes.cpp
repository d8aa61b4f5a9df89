#include <cstdlib>
#include <string>

#include "base/errors.h"
#include "sph_solver/backend/pass_data.h"

namespace tw {

#define TW_DECLARE(isa)        \
    namespace isa {            \
    extern const Passes table; \
    }
TW_DECLARE(baseline)
#ifdef TW_X86_VARIANTS
TW_DECLARE(avx2)
TW_DECLARE(avx512)
#endif
#undef TW_DECLARE

const Passes& passes(const char* isa) {
    const std::string name = isa;
    if (name == "baseline") return baseline::table;
#ifdef TW_X86_VARIANTS
    if (name == "avx2" && __builtin_cpu_supports("x86-64-v3")) return avx2::table;
    if (name == "avx512" && __builtin_cpu_supports("x86-64-v4")) return avx512::table;
#endif
    throw InputError("instruction set " + name +
                     ": not known or not supported by this processor; known: baseline, avx2, avx512");
}

const Passes& passes() {
    if (const char* chosen = std::getenv("TWINWAKE_ISA")) return passes(chosen);
#ifdef TW_X86_VARIANTS
    if (__builtin_cpu_supports("x86-64-v4")) return avx512::table;
    if (__builtin_cpu_supports("x86-64-v3")) return avx2::table;
#endif
    return baseline::table;
}

}  // namespace tw

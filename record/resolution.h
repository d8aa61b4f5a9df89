#pragma once
#include <vector>

#include "base/vec3.h"

namespace tw {

/// A box in which particles or cells are no larger than `size` [m].
struct ResolvedBox {
    double size = 0;  ///< [m]
    Box box;
};

/// The domain, then what of the finer boxes lies in it; their faces may be at infinity.
std::vector<ResolvedBox> resolution_within(const ResolvedBox& domain, const std::vector<ResolvedBox>& finer);

}  // namespace tw

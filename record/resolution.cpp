#include "record/resolution.h"

namespace tw {

std::vector<ResolvedBox> resolution_within(const ResolvedBox& domain, const std::vector<ResolvedBox>& finer) {
    std::vector<ResolvedBox> boxes{domain};
    for (const ResolvedBox& f : finer) {
        const Box cut{f.box.min.cwiseMax(domain.box.min), f.box.max.cwiseMin(domain.box.max)};
        if (cut.size().minCoeff() > 0) boxes.push_back({f.size, cut});
    }
    return boxes;
}

}  // namespace tw

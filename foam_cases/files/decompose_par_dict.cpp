#include <cmath>

#include "foam_cases/files/case_files.h"

namespace tw {

/// system/decomposeParDict: hierarchical, because the scotch of some distributions is an empty shell that fails. Cuts
/// across x and y only: water and air then share every rank.
std::string decompose_par_dict(const CasePlan& plan, int ranks) {
    int across = 1;
    if (plan.scene->domain.dimensions == 3)
        for (int n = 2; n * n <= ranks; ++n)
            if (ranks % n == 0) across = n;
    return foam_file("dictionary", "decomposeParDict",
                     {{"numberOfSubdomains", ranks},
                      {"method", Word("hierarchical")},
                      {"hierarchicalCoeffs",
                       Dictionary{{"n", List{ranks / across, across, 1}}, {"delta", 0.001}, {"order", Word("xyz")}}}});
}

}  // namespace tw

#include "meshes/generate/loft.h"
#include "meshes/generate/shapes.h"

namespace tw {

Surface block(double length, double beam, double height) {
    std::vector<HalfSection> sections;
    for (const double x : {-length / 2, length / 2})
        sections.push_back({{x, 0, 0}, {x, beam / 2, 0}, {x, beam / 2, height}, {x, 0, height}});
    return loft(sections);
}

}  // namespace tw

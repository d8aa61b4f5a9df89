#include <cmath>
#include <numbers>

#include "meshes/generate/loft.h"
#include "meshes/generate/shapes.h"

namespace tw {
namespace {
/// Wigley's parabolic hull: y = (B/2) (1 - xi^2) (1 + a xi^2) (1 - (z/T)^2), xi = 2x/L, for -T <= z <= 0, wall-sided above
/// to the deck. Its volume below the design waterline is (4/9 + 4/45 a) L B T. With a = 0.2 it is model III, of L/B 10 and
/// L/T 16, or IV, of L/B 5, of Journee (1992, report 0909, Delft University of Technology).
Surface make_wigley(const std::map<std::string, double>& v) {
    const double length = v.at("length"), half_beam = v.at("beam") / 2, depth = v.at("design_depth"),
                 freeboard = v.at("freeboard"), fullness = v.at("fullness");
    const int n = static_cast<int>(v.at("stations"));
    constexpr int rows = 24;
    std::vector<HalfSection> sections;
    for (int i = 0; i <= n; ++i) {
        const double xi = (2.0 * i - n) / n;
        const double half_breadth = half_beam * (1 - xi * xi) * (1 + fullness * xi * xi);
        HalfSection section;
        for (int k = 0; k <= rows; ++k) {
            // The girth curves most at the keel, where rows of equal height would be long.
            const double up = 1 - std::cos(0.5 * std::numbers::pi * k / rows), zeta = k == rows ? 0 : up - 1;
            section.emplace_back(0.5 * length * xi, half_breadth * (1 - zeta * zeta), depth * (1 + zeta));
        }
        if (freeboard > 0) section.emplace_back(0.5 * length * xi, half_breadth, depth + freeboard);
        section.emplace_back(0.5 * length * xi, 0, depth + freeboard);
        sections.push_back(std::move(section));
    }
    return loft(sections);
}
}  // namespace

HullShape wigley_shape() {
    return {"wigley",
            "Wigley's parabolic ship hull, wall-sided above its design waterline",
            {{"length", "m", "", 2.5, 1e-2, 500},
             {"beam", "m", "at the design waterline", 0.25, 1e-3, 100},
             {"design_depth", "m", "from the keel to the design waterline", 0.15625, 1e-3, 100},
             {"freeboard", "m", "from the design waterline to the deck", 0.1, 0, 100},
             {"fullness", "-", "of the ends: (1 + fullness xi^2) times as broad; 0.2: Journee's models III and IV", 0,
              0, 1},
             {"stations", "-", "parts along the length", 80, 8, 2000}},
            make_wigley};
}

}  // namespace tw

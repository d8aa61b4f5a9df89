#include "foam_cases/mesh/edge_cells.h"

#include <algorithm>
#include <cmath>

namespace tw {

double smallest_edge_cell(const std::vector<Vec3>& middles, const std::vector<double>& volumes,
                          const std::vector<SheddingEdge>& edges, double reach, double whole) {
    double share = 1;
    for (const SheddingEdge& e : edges) {
        const Vec3 along = e.to - e.from;
        const double length = along.norm();
        if (!(length > 0) || std::abs(along.x()) > 0.5 * length) continue;  // chines and bilges run with the stream
        for (std::size_t i = 0; i < middles.size(); ++i) {
            const Vec3 from = middles[i] - e.from;
            const double at = std::clamp(from.dot(along) / (length * length), 0.0, 1.0);
            if ((from - at * along).norm() <= reach) share = std::min(share, volumes[i] / whole);
        }
    }
    return share;
}

}  // namespace tw

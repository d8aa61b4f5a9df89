#pragma once
#include <map>
#include <utility>

#include "base/vec3.h"

namespace tw {

/// Longest wetted line of a hull [m]: the hull is cut into strips along x, a fifth of its beam wide and a tenth of it
/// apart, and the length of a strip is the extent in x of its wet places. One hull's keel, either keel of a catamaran:
/// both methods take their wetted length from here.
class WettedLine {
public:
    /// `beam` [m]; a plane hull's, 0, makes one strip of everything.
    explicit WettedLine(double beam) : half_width_(0.1 * beam) {}
    void add_wet(const Vec3& place);
    double longest() const;

private:
    double half_width_;
    std::map<long, std::pair<double, double>> strips_;  ///< by middle in half widths: first and last wet x [m]
};

}  // namespace tw

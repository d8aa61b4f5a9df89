#pragma once
#include "base/vec3.h"

namespace tw {

/// Of two boxes, along the axis on which they stand farthest apart [m]; negative where they overlap. What two things in
/// these boxes are apart is at least that.
inline double gap_of_boxes(const Box& a, const Box& b) { return (b.min - a.max).cwiseMax(a.min - b.max).maxCoeff(); }

}  // namespace tw

#pragma once
#include <optional>
#include <vector>

namespace tw {

/// A rectangle on a drawing, y down [px].
struct DrawnBox {
    double left = 0, top = 0, right = 0, bottom = 0;
    bool overlaps(const DrawnBox& b) const {
        return left < b.right && b.left < right && top < b.bottom && b.top < bottom;
    }
    bool holds(const DrawnBox& b) const {
        return left <= b.left && b.right <= right && top <= b.top && b.bottom <= bottom;
    }
};
/// One with a label of this width.
struct LabelBox : DrawnBox {
    double label_width = 0;
};

/// Where the labels of boxes stand: in a corner of their box or beside it, within the frame, on no other label, and
/// across as few edges of boxes as can be. The smallest boxes, which have the least choice, come first. None: no room.
std::vector<std::optional<DrawnBox>> label_places(const std::vector<LabelBox>& boxes, const DrawnBox& frame);

}  // namespace tw

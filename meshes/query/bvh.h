#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "base/vec3.h"
#include "meshes/surface.h"

namespace tw {

/// A tree of boxes over the triangles of a surface, in double precision. Leaves hold up to four triangles, whose
/// corners are copied in leaf order so that a query reads memory in sequence.
class Bvh {
public:
    explicit Bvh(const Surface& surface);

    struct Corners {
        Vec3 a, b, c;  ///< [m]
        int triangle;  ///< index in the surface
    };

    /// Visits the leaf triangles whose boxes `enters(box)` accepts; `visit(corners)` returns false to stop.
    template <class Enters, class Visit>
    void visit(Enters enters, Visit visit) const {
        if (nodes_.empty()) return;
        std::uint32_t stack[deepest];
        int top = 0;
        stack[top++] = 0;
        while (top > 0) {
            const Node& node = nodes_[stack[--top]];
            if (!enters(node.box)) continue;
            if (node.count == 0) {
                stack[top++] = node.first + 1;
                stack[top++] = node.first;
                continue;
            }
            for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
                if (!visit(leaves_[i])) return;
        }
    }

    /// Nearest first: `visit(corners)` returns the squared distance [m2] beyond which nothing is wanted any more.
    template <class Visit>
    void visit_nearest(const Vec3& p, double reach2, Visit visit) const {
        if (nodes_.empty()) return;
        struct Entry {
            std::uint32_t node;
            double distance2;  ///< [m2]
        } stack[deepest];
        int top = 0;
        stack[top++] = {0, distance2(nodes_[0].box, p)};
        while (top > 0) {
            const Entry entry = stack[--top];
            if (entry.distance2 > reach2) continue;
            const Node& node = nodes_[entry.node];
            if (node.count > 0) {
                for (std::uint32_t i = node.first; i < node.first + node.count; ++i) reach2 = visit(leaves_[i]);
                continue;
            }
            Entry near{node.first, distance2(nodes_[node.first].box, p)};
            Entry far{node.first + 1, distance2(nodes_[node.first + 1].box, p)};
            if (far.distance2 < near.distance2) std::swap(near, far);
            if (far.distance2 <= reach2) stack[top++] = far;
            if (near.distance2 <= reach2) stack[top++] = near;
        }
    }

    static double distance2(const Box& box, const Vec3& p) {
        return (box.min - p).cwiseMax(p - box.max).cwiseMax(0.0).squaredNorm();
    }
    /// True when the segment origin + t d, 0 <= t <= length, may meet the box; `inverse` = 1/d by component.
    static bool meets(const Box& box, const Vec3& origin, const Vec3& inverse, double length);

private:
    /// Both sides of a split hold at least an eighth of its triangles, so 2^31 of them are at most 150 levels deep.
    static constexpr int deepest = 192;
    struct Node {
        Box box;
        std::uint32_t first;  ///< left child (the right one follows it), or first leaf triangle
        std::uint32_t count;  ///< triangles of a leaf; 0: inner node
    };
    std::vector<Node> nodes_;
    std::vector<Corners> leaves_;
};

}  // namespace tw

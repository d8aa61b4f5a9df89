#include "base/disjoint_boxes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "base/errors.h"

namespace tw {
namespace {

using Count = std::array<std::size_t, 3>;

std::vector<int> axes_of(int dimensions) {
    return dimensions == 2 ? std::vector<int>{0, 2} : std::vector<int>{0, 1, 2};
}

/// Coordinates of faces along one axis that differ by less than `same` become the smallest of them.
void unite_faces(std::vector<Box>& boxes, int axis, double same) {
    std::vector<double*> faces;
    for (Box& box : boxes) faces.push_back(&box.min[axis]), faces.push_back(&box.max[axis]);
    std::ranges::sort(faces, {}, [](const double* face) { return *face; });
    for (std::size_t k = 1; k < faces.size(); ++k)
        if (*faces[k] - *faces[k - 1] < same) *faces[k] = *faces[k - 1];
}

/// Boxes with less than `gap` between them along one axis that overlap along the others come to meet half way.
void close_gaps(std::vector<Box>& boxes, const std::vector<int>& axes, double gap) {
    for (Box& a : boxes)
        for (Box& b : boxes)
            for (const int axis : axes) {
                const double between = b.min[axis] - a.max[axis];
                if (!(between > 0 && between < gap)) continue;
                const bool beside = std::ranges::all_of(axes, [&](int other) {
                    return other == axis ||
                           std::min(a.max[other], b.max[other]) - std::max(a.min[other], b.min[other]) > gap;
                });
                if (beside) a.max[axis] = b.min[axis] = std::midpoint(a.max[axis], b.min[axis]);
            }
}

/// Whether two boxes share more than an edge.
bool touch(const Box& a, const Box& b, const std::vector<int>& axes) {
    int only_touching = 0;
    for (const int axis : axes) {
        const double common = std::min(a.max[axis], b.max[axis]) - std::max(a.min[axis], b.min[axis]);
        if (common < 0) return false;
        only_touching += common > 0 ? 0 : 1;
    }
    return only_touching <= 1;
}

std::vector<std::vector<Box>> groups_that_touch(const std::vector<Box>& boxes, const std::vector<int>& axes) {
    std::vector<std::vector<Box>> groups;
    std::vector<char> taken(boxes.size(), 0);
    for (std::size_t first = 0; first < boxes.size(); ++first) {
        if (taken[first]) continue;
        taken[first] = 1;
        std::vector<Box>& group = groups.emplace_back(1, boxes[first]);
        for (std::size_t k = 0; k < group.size(); ++k)
            for (std::size_t other = first + 1; other < boxes.size(); ++other)
                if (!taken[other] && touch(group[k], boxes[other], axes))
                    taken[other] = 1, group.push_back(boxes[other]);
    }
    return groups;
}

/// The cells between all faces of a group's boxes, and which of them are filled.
class FilledCells {
public:
    FilledCells(const std::vector<Box>& group, const std::vector<int>& axes) : span_(group.front()) {
        count_ = {1, 1, 1};
        for (const int axis : axes) {
            std::vector<double>& lines = lines_[static_cast<std::size_t>(axis)];
            for (const Box& box : group) lines.push_back(box.min[axis]), lines.push_back(box.max[axis]);
            std::ranges::sort(lines);
            lines.erase(std::ranges::unique(lines).begin(), lines.end());
            count_[static_cast<std::size_t>(axis)] = lines.size() - 1;
        }
        constexpr double most = 1e8;
        if (double(count_[0]) * double(count_[1]) * double(count_[2]) > most)
            throw InputError(
                fmt::format("{} boxes that touch have {} x {} x {} cells between their faces; expected at most {:g}: "
                            "let them share faces",
                            group.size(), count_[0], count_[1], count_[2], most));
        filled_.assign(count_[0] * count_[1] * count_[2], 0);
        for (const Box& box : group) {
            Count low{}, high = count_;
            for (const int axis : axes) {
                const auto a = static_cast<std::size_t>(axis);
                low[a] = line(a, box.min[axis]), high[a] = line(a, box.max[axis]);
            }
            mark(filled_, low, high);
        }
    }

    /// Boxes that fill them, each grown along the axes in this order. `whole`: only by what reaches as far along the
    /// axes before, so that a column beside a higher one is a box of its own and leaves no sliver of that.
    std::vector<Box> divided(const std::array<std::size_t, 3>& order, bool whole) const {
        std::vector<Box> boxes;
        std::vector<char> left = filled_;
        for (std::size_t cell = 0; cell < left.size(); ++cell) {
            if (!left[cell]) continue;
            Count low{cell / (count_[1] * count_[2]), cell / count_[2] % count_[1], cell % count_[2]};
            Count high{low[0] + 1, low[1] + 1, low[2] + 1};
            for (std::size_t n = 0; n < 3; ++n)
                for (const std::size_t a = order[n]; high[a] < count_[a]; ++high[a]) {
                    Count from = low, to = high;
                    from[a] = high[a], to[a] = high[a] + 1;
                    if (!all(left, from, to)) break;
                    if (whole && std::any_of(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(n),
                                             [&](std::size_t before) { return goes_on(left, from, to, before); }))
                        break;
                }
            mark(left, low, high, 0);
            Box& box = boxes.emplace_back(span_);
            for (std::size_t a = 0; a < 3; ++a)
                if (!lines_[a].empty()) {
                    const auto axis = static_cast<int>(a);
                    box.min[axis] = lines_[a][low[a]], box.max[axis] = lines_[a][high[a]];
                }
        }
        return boxes;
    }

private:
    std::size_t line(std::size_t a, double x) const {
        return static_cast<std::size_t>(std::ranges::lower_bound(lines_[a], x) - lines_[a].begin());
    }
    template <class Act>
    bool each(const Count& low, const Count& high, const Act& act) const {
        for (std::size_t i = low[0]; i < high[0]; ++i)
            for (std::size_t j = low[1]; j < high[1]; ++j)
                for (std::size_t k = low[2]; k < high[2]; ++k)
                    if (!act((i * count_[1] + j) * count_[2] + k)) return false;
        return true;
    }
    void mark(std::vector<char>& cells, const Count& low, const Count& high, char as = 1) const {
        each(low, high, [&](std::size_t cell) {
            cells[cell] = as;
            return true;
        });
    }
    /// Whether cells are left beyond either end of a part along an axis.
    bool goes_on(const std::vector<char>& cells, Count low, Count high, std::size_t axis) const {
        const auto none = [&](std::size_t cell) { return cells[cell] == 0; };
        const std::size_t first = low[axis], last = high[axis];
        bool ends = true;
        if (first > 0) low[axis] = first - 1, high[axis] = first, ends = each(low, high, none);
        if (last < count_[axis]) low[axis] = last, high[axis] = last + 1, ends = ends && each(low, high, none);
        return !ends;
    }
    bool all(const std::vector<char>& cells, const Count& low, const Count& high) const {
        return each(low, high, [&](std::size_t cell) { return cells[cell] != 0; });
    }

    Box span_;
    std::array<std::vector<double>, 3> lines_;  ///< none along an axis that counts for nothing
    Count count_;
    std::vector<char> filled_;
};

double thinnest(const std::vector<Box>& boxes, const std::vector<int>& axes) {
    double least = 1e300;
    for (const Box& box : boxes)
        for (const int axis : axes) least = std::min(least, box.size()[axis]);
    return least;
}

std::vector<Box> divided_anew(const std::vector<Box>& group, const std::vector<int>& axes, double enough) {
    if (group.size() == 1) return group;
    const FilledCells cells(group, axes);
    std::array<std::size_t, 3> order{0, 1, 2};
    std::vector<Box> best;
    double best_thickness = -1;
    do {
        for (const bool whole : {false, true}) {
            std::vector<Box> boxes = cells.divided(order, whole);
            const double thickness = std::min(thinnest(boxes, axes), enough);
            if (thickness > best_thickness || (thickness == best_thickness && boxes.size() < best.size()))
                best = std::move(boxes), best_thickness = thickness;
        }
    } while (std::ranges::next_permutation(order).found);
    return best;
}

}  // namespace

std::vector<std::vector<Box>> disjoint_groups(std::span<const Box> boxes, int dimensions, double gap) {
    const std::vector<int> axes = axes_of(dimensions);
    std::vector<Box> all(boxes.begin(), boxes.end());
    for (const int axis : axes) unite_faces(all, axis, 1e-3 * gap);
    close_gaps(all, axes, gap);
    std::vector<std::vector<Box>> groups = groups_that_touch(all, axes);
    for (std::vector<Box>& group : groups) group = divided_anew(group, axes, 12 * gap);
    return groups;
}

std::vector<Box> disjoint_boxes(std::span<const Box> boxes, int dimensions, double gap) {
    std::vector<Box> all;
    for (const std::vector<Box>& group : disjoint_groups(boxes, dimensions, gap))
        all.insert(all.end(), group.begin(), group.end());
    return all;
}

}  // namespace tw

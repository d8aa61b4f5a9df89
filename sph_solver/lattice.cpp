#include "sph_solver/lattice.h"

namespace tw {
namespace {

using Counts = std::array<long, 3>;
constexpr double volume_tolerance = 0.01;  ///< cells of nearest counts are kept where their volume is this near

/// How far a cell's volume is from that of `dp` in each direction, and its edges from dp: logarithms.
double misfit(const Vec3& size, const Counts& counts, double dp, const std::vector<int>& axes) {
    double volume = 0, edge = 0;
    for (const int a : axes) {
        const double stretch = std::log(size[a] / static_cast<double>(counts[std::size_t(a)]) / dp);
        volume += stretch, edge = std::max(edge, std::abs(stretch));
    }
    return std::abs(volume) + edge;
}

Counts counts_of(const Box& box, double dp, const std::vector<int>& axes) {
    const Vec3 size = box.size();
    Counts nearest{1, 1, 1};
    double stretch = 1;
    for (const int a : axes) {
        nearest[std::size_t(a)] = std::max(1L, std::lround(size[a] / dp));
        stretch *= size[a] / dp / static_cast<double>(nearest[std::size_t(a)]);
    }
    if (std::abs(stretch - 1) < volume_tolerance) return nearest;
    int longest = axes.front();
    for (const int a : axes)
        if (size[a] > size[longest]) longest = a;
    Counts best{1, 1, 1}, tried{1, 1, 1};
    double least = 1e300;
    for (int choice = 0; choice < (1 << axes.size()); ++choice) {
        double rest = size[longest] / dp;
        for (std::size_t n = 0; n < axes.size(); ++n) {
            const int a = axes[n];
            if (a == longest) continue;
            const double cells = size[a] / dp;
            const double whole = std::max(1.0, std::floor(cells + 1e-9) + (choice >> n & 1));
            tried[std::size_t(a)] = static_cast<long>(whole);
            rest *= cells / whole;
        }
        tried[std::size_t(longest)] = std::max(1L, std::lround(rest));
        if (const double found = misfit(size, tried, dp, axes); found < least - 1e-9) least = found, best = tried;
    }
    return best;
}

/// Whether rows along and across a face that two lattices share go on through it, to a fiftieth of a cell.
bool fit_together(const Lattice& a, const Lattice& b, const Box& seam) {
    constexpr double tolerance = 0.02;
    for (int axis = 0; axis < 3; ++axis) {
        if (axis == 1 && a.flat) continue;
        const double stretch = std::abs(a.cell[axis] / b.cell[axis] - 1), length = seam.size()[axis] / a.cell[axis],
                     apart = (a.corner[axis] - b.corner[axis]) / a.cell[axis];
        if (stretch * std::max(1.0, length) > tolerance) return false;
        if (length > 0 && std::abs(apart - std::round(apart)) > tolerance) return false;
    }
    return true;
}

}  // namespace

std::vector<Lattice> lattices_of(int dimensions, double dp, std::span<const Box> boxes, int halvings) {
    std::vector<Lattice> lattices;
    const std::vector<int> axes = dimensions == 2 ? std::vector<int>{0, 2} : std::vector<int>{0, 1, 2};
    for (const Box& box : boxes)
        if (boxes.size() == 1)
            lattices.emplace_back(dimensions, dp, box, halvings);
        else
            lattices.emplace_back(dimensions, box, counts_of(box, std::ldexp(dp, halvings), axes), halvings);
    return lattices;
}

std::vector<Box> unfit_seams(std::span<const Box> boxes, std::span<const Lattice> lattices) {
    std::vector<Box> seams;
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = i + 1; j < boxes.size(); ++j) {
            Box seam{boxes[i].min.cwiseMax(boxes[j].min), boxes[i].max.cwiseMin(boxes[j].max)};
            if (lattices[i].flat) seam.min.y() = -0.5, seam.max.y() = 0.5;
            const Vec3 size = seam.size();
            const auto flat_axes = (size.array() == 0).count();
            if (size.minCoeff() < 0 || flat_axes != 1 || fit_together(lattices[i], lattices[j], seam)) continue;
            seams.push_back(seam);
        }
    return seams;
}

}  // namespace tw

#include "scene/water/water_grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tw {
namespace {

/// Planes on all faces along an axis, and between them so many that cells are about `spacing`.
std::vector<double> planes_through(std::span<const Box> boxes, int axis, double spacing) {
    std::vector<double> faces;
    for (const Box& box : boxes) faces.push_back(box.min[axis]), faces.push_back(box.max[axis]);
    std::ranges::sort(faces);
    faces.erase(std::ranges::unique(faces).begin(), faces.end());
    std::vector<double> planes{faces.front()};
    for (std::size_t k = 1; k < faces.size(); ++k) {
        const double from = faces[k - 1], length = faces[k] - from;
        const double cells = std::max(1.0, std::round(length / spacing));
        for (double i = 1; i <= cells; ++i) planes.push_back(i < cells ? from + length * i / cells : faces[k]);
    }
    return planes;
}

}  // namespace

WaterGrid::WaterGrid(std::span<const Box> boxes, const WaterBounds& bounds, double spacing, double most)
    : bounds_(bounds) {
    divide(boxes, spacing, most);
    fill(boxes);
    find_faces();
    connect();
}

void WaterGrid::divide(std::span<const Box> boxes, double spacing, double most) {
    for (double before = 0;; spacing *= 2) {
        double cells = 1;
        for (int a = 0; a < 3; ++a) {
            const auto axis = static_cast<std::size_t>(a);
            planes_[axis] =
                a == 1 && bounds_.dimensions == 2 ? std::vector{-0.5, 0.5} : planes_through(boxes, a, spacing);
            cells *= double(planes_[axis].size() - 1);
        }
        if (cells <= most || cells == before) return;
        before = cells;
    }
}

std::size_t WaterGrid::index(const std::array<std::int32_t, 3>& at) const {
    std::size_t k = 0;
    for (std::size_t a = 0; a < 3; ++a) k = k * (planes_[a].size() - 1) + static_cast<std::size_t>(at[a]);
    return k;
}

Vec3 WaterGrid::size(const Cell& c) const {
    Vec3 s;
    for (int a = 0; a < 3; ++a) {
        const double* plane = &planes_[std::size_t(a)][std::size_t(c.at[std::size_t(a)])];
        s[a] = plane[1] - plane[0];
    }
    return s;
}

Vec3 WaterGrid::middle(const Cell& c) const {
    Vec3 x;
    for (int a = 0; a < 3; ++a) {
        const double* plane = &planes_[std::size_t(a)][std::size_t(c.at[std::size_t(a)])];
        x[a] = std::midpoint(plane[0], plane[1]);
    }
    return x;
}

Vec3 WaterGrid::face(const Cell& c, int axis, int side) const {
    Vec3 x = middle(c);
    x[axis] = planes_[std::size_t(axis)][std::size_t(c.at[std::size_t(axis)] + side)];
    return x;
}

void WaterGrid::fill(std::span<const Box> boxes) {
    cell_.assign((planes_[0].size() - 1) * (planes_[1].size() - 1) * (planes_[2].size() - 1), no_water);
    const auto range = [&](const Box& box, std::size_t a) {
        const std::vector<double>& planes = planes_[a];
        if (a == 1 && bounds_.dimensions == 2) return std::pair<std::int32_t, std::int32_t>{0, 1};
        const auto at = [&](double x) {
            return static_cast<std::int32_t>(std::ranges::lower_bound(planes, x) - planes.begin());
        };
        return std::pair{at(box.min[int(a)]), at(box.max[int(a)])};
    };
    for (const Box& box : boxes) {
        const auto [i0, i1] = range(box, 0);
        const auto [j0, j1] = range(box, 1);
        const auto [k0, k1] = range(box, 2);
        for (std::int32_t i = i0; i < i1; ++i)
            for (std::int32_t j = j0; j < j1; ++j)
                for (std::int32_t k = k0; k < k1; ++k) cells_.push_back({{i, j, k}, -1, {}, {}});
    }
    std::vector<Vec3> middles;
    for (const Cell& c : cells_) middles.push_back(middle(c)), reach_ = std::max(reach_, size(c).norm());
    if (bounds_.dimensions == 2) {
        reach_ = 0;
        for (const Cell& c : cells_) reach_ = std::max(reach_, std::hypot(size(c).x(), size(c).z()));
    }
    reach_ += bounds_.clear;
    to_solid_.assign(cells_.size(), reach_);
    std::vector<double> distance(cells_.size());
    for (const SurfaceQuery& solid : bounds_.solids) {
        solid.signed_distances(middles, distance, reach_);
        for (std::size_t c = 0; c < cells_.size(); ++c) to_solid_[c] = std::min(to_solid_[c], distance[c]);
    }
    std::size_t kept = 0;
    for (std::size_t c = 0; c < cells_.size(); ++c) {
        cell_[index(cells_[c].at)] = in_solid;
        if (!(to_solid_[c] > 0)) continue;
        cells_[kept] = cells_[c], to_solid_[kept] = to_solid_[c];
        cell_[index(cells_[kept].at)] = static_cast<std::int32_t>(kept);
        ++kept;
    }
    cells_.resize(kept), to_solid_.resize(kept);
}

bool WaterGrid::solid_between(const Vec3& a, const Vec3& b, double distance) const {
    if (distance > (b - a).norm()) return false;
    return std::ranges::any_of(bounds_.solids, [&](const SurfaceQuery& s) { return s.crosses(a, b) || s.inside(b); });
}

void WaterGrid::find_faces() {
    for (std::size_t n = 0; n < cells_.size(); ++n) {
        Cell& c = cells_[n];
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t side = 0; side < 2; ++side) {
                c.beside[a][side] = -1, c.face[a][side] = Face::wall;
                if (a == 1 && bounds_.dimensions == 2) continue;
                const Vec3 here = middle(c);
                std::array<std::int32_t, 3> next = c.at;
                next[a] += side == 0 ? -1 : 1;
                const bool within = next[a] >= 0 && next[a] + 1 < static_cast<std::int32_t>(planes_[a].size());
                const std::int32_t beside = within ? cell_[index(next)] : no_water;
                if (beside == in_solid) continue;
                if (beside >= 0) {
                    if (solid_between(here, middle(cells_[std::size_t(beside)]), to_solid_[n])) continue;
                    c.beside[a][side] = beside, c.face[a][side] = Face::open;
                    continue;
                }
                Vec3 beyond = face(c, int(a), int(side));
                beyond[int(a)] += side == 0 ? -bounds_.clear : bounds_.clear;
                const bool walled = bounds_.walls[a][side] && (side == 0 ? beyond[int(a)] < bounds_.domain.min[int(a)]
                                                                         : beyond[int(a)] > bounds_.domain.max[int(a)]);
                if (!walled && !solid_between(here, beyond, to_solid_[n])) c.face[a][side] = Face::free;
            }
    }
}

void WaterGrid::connect() {
    std::vector<std::int32_t> found;
    for (std::size_t first = 0; first < cells_.size(); ++first) {
        if (cells_[first].part >= 0) continue;
        const auto number = static_cast<std::int32_t>(parts_.size());
        Part& part = parts_.emplace_back();
        double top = -1e300, low_level = 1e300, high_level = -1e300;
        part.bounds = {Vec3::Constant(1e300), Vec3::Constant(-1e300)};
        cells_[first].part = number;
        found.assign(1, static_cast<std::int32_t>(first));
        while (!found.empty()) {
            Cell& c = cells_[std::size_t(found.back())];
            found.pop_back();
            ++part.cells;
            top = std::max(top, face(c, 2, 1).z());
            part.bounds.min = part.bounds.min.cwiseMin(middle(c) - size(c) / 2);
            part.bounds.max = part.bounds.max.cwiseMax(middle(c) + size(c) / 2);
            for (std::size_t a = 0; a < 3; ++a)
                for (std::size_t side = 0; side < 2; ++side) {
                    if (c.face[a][side] == Face::free) {
                        part.is_free = true;
                        if (a != 2 || side == 0) part.let_go = true;
                        if (a == 2 && side == 1) {
                            low_level = std::min(low_level, face(c, 2, 1).z());
                            high_level = std::max(high_level, face(c, 2, 1).z());
                        }
                    }
                    const std::int32_t beside = c.beside[a][side];
                    if (beside < 0 || cells_[std::size_t(beside)].part >= 0) continue;
                    cells_[std::size_t(beside)].part = number;
                    found.push_back(beside);
                }
        }
        part.level = high_level > -1e300 ? high_level : top;
        part.lowest = high_level - low_level > 0.01 * bounds_.clear ? low_level : part.level;
    }
}

std::int32_t WaterGrid::cell_near(const Vec3& place) const {
    std::array<std::int32_t, 3> at{}, low{}, high{};
    for (std::size_t a = 0; a < 3; ++a) {
        const std::vector<double>& planes = planes_[a];
        const auto last = static_cast<std::int32_t>(planes.size()) - 2;
        const auto above = std::ranges::upper_bound(planes, place[int(a)]) - planes.begin();
        at[a] = std::clamp(static_cast<std::int32_t>(above) - 1, 0, last);
        low[a] = std::max(at[a] - 1, 0), high[a] = std::min(at[a] + 1, last);
    }
    const auto reaches = [&](std::int32_t c) {
        return !solid_between(middle(cells_[std::size_t(c)]), place, to_solid_[std::size_t(c)]);
    };
    if (const std::int32_t c = cell_[index(at)]; c >= 0 && reaches(c)) return c;
    std::int32_t best = -1;
    double nearest = 1e300;
    for (std::int32_t i = low[0]; i <= high[0]; ++i)
        for (std::int32_t j = low[1]; j <= high[1]; ++j)
            for (std::int32_t k = low[2]; k <= high[2]; ++k) {
                const std::int32_t c = cell_[index({i, j, k})];
                if (c < 0) continue;
                const double distance = (middle(cells_[std::size_t(c)]) - place).norm();
                if (distance < nearest && reaches(c)) best = c, nearest = distance;
            }
    return best;
}

}  // namespace tw

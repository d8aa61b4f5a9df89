#include "sph_solver/bodies/water_film.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "meshes/section.h"

namespace tw {
namespace {

constexpr double neighbours_within = 1.25;  // spacings
constexpr double facing = 0.5;              // cosine between a face's normal and the wall's from which it faces it
constexpr float full_support = 0.4f;        // from which on particles are at a face: half on a flat wall
constexpr double small = 0.125;             // dp^2: patches below lie in cells of half a spacing

/// Where one patch takes the place of all small ones: of a cell, and of about one direction.
using Place = std::array<long, 6>;
Place place_of(const Vec3& x, const Vec3& area, double cell) {
    Place p;
    const Vec3 n = area.normalized();
    for (std::size_t a = 0; a < 3; ++a) {
        const auto i = static_cast<Eigen::Index>(a);
        p[a] = static_cast<long>(std::floor(x[i] / cell)), p[a + 3] = std::lround(2 * n[i]);
    }
    return p;
}

}  // namespace

WaterFilm::WaterFilm(const Surface& surface, int dimensions, double dp) : dp_(dp) {
    const SurfaceSamples samples = dimensions == 2 ? SurfaceSamples::of_section(with_span(surface, 1), dp)
                                                   : SurfaceSamples(surface, dp, surface.bounds());
    for (std::size_t k = 0; k < samples.area.size(); ++k) {
        const Vec3& place = samples.points.places[k];
        if (!at_start_.empty() && at_start_.back() == place) {  // the two halves of a strip
            area_.back() += samples.area[k];
            continue;
        }
        at_start_.push_back(place);
        area_.push_back(samples.area[k]);
    }
    merge_small();
    find_neighbours();
}

void WaterFilm::merge_small() {
    struct Sum {
        Vec3 moment = Vec3::Zero(), area = Vec3::Zero();
        double size = 0;
    };
    std::map<Place, Sum> merged;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < at_start_.size(); ++k) {
        const double size = area_[k].norm();
        if (size >= small * dp_ * dp_) {
            at_start_[kept] = at_start_[k], area_[kept++] = area_[k];
        } else if (size > 0) {
            Sum& sum = merged[place_of(at_start_[k], area_[k], dp_ / 2)];
            sum.moment += size * at_start_[k], sum.area += area_[k], sum.size += size;
        }
    }
    at_start_.resize(kept), area_.resize(kept);
    for (const auto& [place, sum] : merged) {
        at_start_.push_back(sum.moment / sum.size);
        area_.push_back(sum.area);
    }
}

void WaterFilm::find_neighbours() {
    const double reach = neighbours_within * dp_;
    using Cell = std::array<long, 3>;
    const auto cell_of = [&](const Vec3& x) {
        Cell c;
        for (int a = 0; a < 3; ++a) c[static_cast<std::size_t>(a)] = static_cast<long>(std::floor(x[a] / reach));
        return c;
    };
    std::map<Cell, std::vector<std::size_t>> cells;
    for (std::size_t k = 0; k < at_start_.size(); ++k) cells[cell_of(at_start_[k])].push_back(k);
    beside_.resize(at_start_.size());
    for (std::size_t k = 0; k < at_start_.size(); ++k) {
        const Cell c = cell_of(at_start_[k]);
        for (long i = -1; i <= 1; ++i)
            for (long j = -1; j <= 1; ++j)
                for (long l = -1; l <= 1; ++l) {
                    const auto found = cells.find({c[0] + i, c[1] + j, c[2] + l});
                    if (found == cells.end()) continue;
                    for (const std::size_t other : found->second)
                        if (const double r2 = (at_start_[k] - at_start_[other]).squaredNorm();
                            other != k && r2 > 0 && r2 < reach * reach)
                            beside_[k].push_back({other, 1 / r2});
                }
    }
}

double WaterFilm::share(double gap) const { return std::clamp(2 - gap / dp_, 0.0, 1.0); }

std::vector<Vec3> WaterFilm::places(const RigidBody& body) const {
    std::vector<Vec3> now;
    now.reserve(at_start_.size());
    for (const Vec3& x : at_start_) now.push_back(body.now(x));
    return now;
}

/// Conjugate gradients: the matrix of the film's own patches is symmetric and, with a rim, positive definite.
void WaterFilm::settle(const std::vector<std::size_t>& film, const std::vector<double>& dry_head,
                       const std::vector<char>& wet, std::vector<double>& head) const {
    constexpr double settled = 1e-8;
    const std::size_t n = film.size();
    std::vector<std::ptrdiff_t> unknown(head.size(), -1);
    for (std::size_t i = 0; i < n; ++i) unknown[film[i]] = static_cast<std::ptrdiff_t>(i);
    std::vector<double> x(n, 0), r(n, 0), p, Ap(n);
    double rr = 0;
    for (std::size_t i = 0; i < n; ++i) {
        for (const Neighbour& b : beside_[film[i]])
            if (unknown[b.patch] < 0) r[i] += b.weight * (wet[b.patch] ? head[b.patch] : dry_head[film[i]]);
        rr += r[i] * r[i];
    }
    p = r;
    const double enough = settled * settled * rr;
    for (std::size_t round = 0; round < 10 * n && rr > enough; ++round) {
        double pAp = 0;
        for (std::size_t i = 0; i < n; ++i) {
            Ap[i] = 0;
            for (const Neighbour& b : beside_[film[i]]) {
                const std::ptrdiff_t j = unknown[b.patch];
                Ap[i] += b.weight * (p[i] - (j < 0 ? 0 : p[static_cast<std::size_t>(j)]));
            }
            pAp += p[i] * Ap[i];
        }
        if (!(pAp > 0)) break;
        const double step = rr / pAp, before = rr;
        rr = 0;
        for (std::size_t i = 0; i < n; ++i) {
            x[i] += step * p[i];
            r[i] -= step * Ap[i];
            rr += r[i] * r[i];
        }
        for (std::size_t i = 0; i < n; ++i) p[i] = r[i] + rr / before * p[i];
    }
    for (std::size_t i = 0; i < n; ++i) head[film[i]] = x[i];
}

Load WaterFilm::load(const RigidBody& body, const WallContact& walls, const PointSamples& samples,
                     const Vec3& weight) const {
    const std::size_t n = at_start_.size();
    const Vec3 origin = body.state().centre;  // near, so that heads are small
    std::vector<double> dry_head(n), head(n), film_share(n, 0);
    std::vector<char> wet(n);
    std::vector<std::size_t> film;
    for (std::size_t k = 0; k < n; ++k) {
        wet[k] = samples.support[k] >= SurfaceSamples::has_pressure;
        dry_head[k] = -weight.dot(samples.places[k] - origin);
        head[k] = (wet[k] ? double(samples.p[k]) : 0) + dry_head[k];
        if (samples.support[k] >= full_support) continue;
        const Vec3 out = (body.state().attitude * area_[k]).normalized();
        for (const WallPlane& wall : walls.walls())
            if (out.dot(wall.normal) < -facing)
                film_share[k] = std::max(film_share[k], share(wall.normal.dot(samples.places[k]) - wall.offset));
        if (film_share[k] > 0) film.push_back(k);
    }
    std::vector<double> of_film = head;
    settle(film, dry_head, wet, of_film);
    Load all;
    for (std::size_t k = 0; k < n; ++k) {
        double p = wet[k] ? double(samples.p[k]) : 0;
        if (film_share[k] > 0) p += film_share[k] * (std::max(0.0, of_film[k] - dry_head[k]) - p);
        const Vec3 force = -p * (body.state().attitude * area_[k]);
        all.force += force;
        all.moment += (samples.places[k] - origin).cross(force);
    }
    return all;
}

}  // namespace tw

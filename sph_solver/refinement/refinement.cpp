#include "sph_solver/refinement/refinement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <unordered_map>
#include <unordered_set>

#include "sph_solver/backend/for_particles.h"
#include "sph_solver/backend/stopwatch.h"

namespace tw {

namespace {

/// From this kernel support on the other level covers a place, half a fine spacing below a plane free surface included.
constexpr float covered = 0.5f;

/// Fine places among coarse particles and coarse ones among fine, in spacings of those.
constexpr double fine_apart = 0.5, coarse_apart = 2;

Vec3 place_of(const Particles& p, std::size_t i) { return {p.x[i], p.y[i], p.z[i]}; }

/// The particles of some kinds.
template <class Of>
std::vector<std::size_t> those(const Particles& p, const Of& of) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < p.size(); ++i)
        if (of(p.kind[i])) found.push_back(i);
    return found;
}

void set_fields(Particles& p, std::size_t i, const VelocityDensityRecord& r) {
    p.u[i] = r.u, p.v[i] = r.v, p.w[i] = r.w, p.drho[i] = r.drho;
}

std::int64_t orphans(const FieldsAt& at) {
    std::int64_t n = 0;
    for (std::size_t k = 0; k < at.places.size(); ++k) n += !at.given(k).known();
    return n;
}

/// The distance from a zone's edge: what is known of it, or worked out again.
double ask_edge(const AskEdge& ask, const Zone& zone, const Vec3& at, EdgeDistance& known) {
    const V3<double> x{at.x(), at.y(), at.z()};
    if (ask.knows(x, known)) return double(known.outside);
    const double outside = zone.outside(at);
    known = ask.found(x, outside);
    return outside;
}

/// Points in cells of a size, to ask which is nearest.
class Crowd {
public:
    Crowd(double size, int dimensions) : size_(size), across_(dimensions == 3 ? 1 : 0) {}
    void add(const Vec3& x, std::size_t which) { cells_.emplace(key(cell(x)), Point{x, which}); }
    /// From now on `is_marked` holds within a size of x, and for some way beyond.
    void mark(const Vec3& x) {
        each_round(x, [&](std::uint64_t k) { marked_.insert(k); });
    }
    bool is_marked(const Vec3& x) const { return marked_.contains(key(cell(x))); }
    /// The nearest point within a size of x.
    std::optional<std::size_t> nearest(const Vec3& x) const {
        std::optional<std::size_t> found;
        double least = size_ * size_;
        each_round(x, [&](std::uint64_t k) {
            const auto [first, last] = cells_.equal_range(k);
            for (auto it = first; it != last; ++it) {
                const double d2 = (it->second.x - x).squaredNorm();
                if (d2 < least || (d2 == least && found && it->second.which < *found))
                    least = d2, found = it->second.which;
            }
        });
        return found;
    }

private:
    struct Point {
        Vec3 x;
        std::size_t which;
    };
    using Cell = std::array<std::int64_t, 3>;
    Cell cell(const Vec3& x) const {
        return {std::llround(x.x() / size_), std::llround(x.y() / size_), std::llround(x.z() / size_)};
    }
    static std::uint64_t key(const Cell& c) {
        const auto bits = [](std::int64_t k) { return static_cast<std::uint64_t>(k) & 0x1fffff; };
        return bits(c[0]) << 42 | bits(c[1]) << 21 | bits(c[2]);
    }
    template <class Function>
    void each_round(const Vec3& x, const Function& f) const {
        const Cell at = cell(x);
        for (int i = -1; i <= 1; ++i)
            for (int j = -across_; j <= across_; ++j)
                for (int k = -1; k <= 1; ++k) f(key({at[0] + i, at[1] + j, at[2] + k}));
    }
    double size_;
    int across_;
    std::unordered_multimap<std::uint64_t, Point> cells_;
    std::unordered_set<std::uint64_t> marked_;
};

}  // namespace

Refinement::Refinement(Level& coarse, Level& fine, Zone zone, const Refinement* outer)
    : coarse_(coarse),
      fine_(fine),
      outer_(outer),
      zone_(std::move(zone)),
      dp_(fine.setup().dp),
      excess_(coarse.kernel(), coarse.setup().dp, coarse.dimensions()) {
    Particles &c = coarse.particles(), &f = fine.particles();
    f.bring(With::coarser);
    c.bring(With::finer);
    for (std::size_t i = 0; i < c.size(); ++i)
        if (belongs(zone_, place_of(c, i), dp_)) c.children[i] = Children::all;
    for (std::size_t i = 0; i < f.size(); ++i)
        if (zone_.outside(place_of(f, i)) >= 0) f.kind[i] = Kind::guard;
    label_coarse();
    surplus_at_start_ = surplus();
}

void Refinement::set_zone(Zone zone) {
    const std::optional<Zone::Shift> shift = zone.shift_since(zone_);
    zone_ = std::move(zone);
    if (shift) {
        shifted_.by += shift->by;
        shifted_.turn += shift->turn;
        gone_since_ += shift->by + shift->turn * zone_.pivot_radius();
        return;
    }
    gone_since_ = std::numeric_limits<double>::infinity();
    if (coarse_.device()) {
        fine_.device()->forget_edge(With::coarser), coarse_.device()->forget_edge(With::finer);
        return;
    }
    std::ranges::fill(fine_.particles().from_edge, EdgeDistance{});
    std::ranges::fill(coarse_.particles().from_finer_edge, EdgeDistance{});
}

AskEdge Refinement::edge(std::initializer_list<double> limits) const {
    const Vec3 pivot = zone_.pivot();
    AskEdge ask{.limits = {},
                .count = static_cast<int>(limits.size()),
                .steepest = Zone::steepest,
                .by = shifted_.by,
                .turn = shifted_.turn,
                .pivot = {pivot.x(), pivot.y(), pivot.z()}};
    std::ranges::copy(limits, ask.limits);
    return ask;
}

AskEdge Refinement::edge_for_coarse() const {
    return edge({-band_over_dp * dp_, 0.0, guard_over_dp * dp_, again_over_dp * dp_, barren_over_dp * dp_});
}

LabelCoarse Refinement::labels() const {
    return {.band = band_over_dp * dp_, .again = again_over_dp * dp_, .barren = barren_over_dp * dp_};
}

void Refinement::label_coarse() {
    Particles& c = coarse_.state_to_change();
    outside_coarse_.resize(c.size());
    const AskEdge ask = edge_for_coarse();
    LabelCoarse label = labels();
    label.kind = c.kind.data(), label.children = c.children.data();
    for_particles(c.size(), [&](std::size_t i) {
        outside_coarse_[i] = ask_edge(ask, zone_, place_of(c, i), c.from_finer_edge[i]);
        label(i, outside_coarse_[i]);
    });
}

void Refinement::relabel() {
    const Stopwatch watch(ledger_.seconds);
    const bool due = fine_.lists_due() || fine_.lists_outlived() || gone_since_ + in_a_step_ >= patience_over_dp * dp_;
    if (!due && coarse_.device()) return coarse_.device()->label(edge_for_coarse(), labels(), zone_);
    label_coarse();
    if (!due) return;
    gone_since_ = 0;
    Particles& f = fine_.state_to_change();
    const AskEdge ask = edge({0.0, gone_over_dp * dp_});
    std::vector<double> outside(f.size());
    for_particles(f.size(), [&](std::size_t i) { outside[i] = ask_edge(ask, zone_, place_of(f, i), f.from_edge[i]); });
    std::vector<char> gone(f.size(), 0);
    FieldsAt leaving;
    leaving.of = Giving::all;
    leaving.apart = fine_apart;
    std::vector<std::size_t> who;
    for (std::size_t i = 0; i < f.size(); ++i) {
        const double s = outside[i];
        if (f.kind[i] == Kind::guard && s < 0) f.kind[i] = Kind::fluid;
        if (f.kind[i] == Kind::fluid && s >= 0) leaving.places.push_back(place_of(f, i)), who.push_back(i);
        gone[i] = f.kind[i] == Kind::guard && s > gone_over_dp * dp_;
    }
    coarse_.interpolate(leaving);
    std::vector<std::size_t> spray;
    for (std::size_t k = 0; k < who.size(); ++k) {
        const std::size_t i = who[k];
        if (leaving.support[k] < covered) {
            spray.push_back(i);
            continue;
        }
        f.kind[i] = Kind::guard;
        f.trend[i].support = leaving.mean_support[k];
        gone[i] = outside[i] > gone_over_dp * dp_;
    }
    ledger_.spray = static_cast<std::int64_t>(spray.size());
    std::erase_if(spray, [&](std::size_t i) { return outside[i] <= gone_over_dp * dp_; });
    for (const Refinement* edge = outer_; edge && !spray.empty(); edge = edge->outer_) {
        const std::vector<char> fallen = edge->covers(f, spray);
        for (std::size_t k = 0; k < spray.size(); ++k) gone[spray[k]] = fallen[k];
        ledger_.spray -= static_cast<std::int64_t>(std::erase_if(spray, [&](std::size_t i) { return gone[i] != 0; }));
    }
    remove(gone);
    give_birth();
}

std::vector<char> Refinement::covers(const Particles& p, const std::vector<std::size_t>& who) const {
    FieldsAt at;
    at.of = Giving::all;
    at.apart = fine_apart;
    for (const std::size_t i : who) at.places.push_back(place_of(p, i));
    coarse_.interpolate(at);
    std::vector<char> yes;
    for (const float support : at.support) yes.push_back(support >= covered);
    return yes;
}

std::vector<Vec3> Refinement::octants(const Vec3& parent) const {
    std::vector<Vec3> places;
    for (int octant = 0; octant < (coarse_.dimensions() == 3 ? 8 : 4); ++octant) {
        const double half = dp_ / 2;
        const Vec3 to(octant & 1 ? half : -half,
                      coarse_.dimensions() == 2 ? 0
                      : octant & 4              ? half
                                                : -half,
                      octant & 2 ? half : -half);
        places.push_back(parent + to);
    }
    return places;
}

std::unordered_map<std::size_t, std::vector<std::size_t>> Refinement::families_of(
    const std::vector<std::size_t>& parents) const {
    const Particles &c = coarse().particles(), &f = fine().particles();
    std::unordered_map<std::size_t, std::vector<std::size_t>> families;
    if (parents.empty()) return families;
    Crowd crowd(coarse_.setup().dp, coarse_.dimensions());
    for (const std::size_t i : parents) families[i], crowd.mark(place_of(c, i));
    for (std::size_t i = 0; i < c.size(); ++i)
        if (outside_coarse_[i] > 0 && outside_coarse_[i] < band_over_dp * dp_ && crowd.is_marked(place_of(c, i)))
            crowd.add(place_of(c, i), i);
    for (std::size_t i = 0; i < f.size(); ++i) {
        if (f.kind[i] != Kind::guard || !crowd.is_marked(place_of(f, i))) continue;
        const std::optional<std::size_t> parent = crowd.nearest(place_of(f, i));
        if (!parent) continue;
        if (const auto family = families.find(*parent); family != families.end()) family->second.push_back(i);
    }
    return families;
}

void Refinement::give_birth() {
    Particles &c = coarse_.state_to_change(), &f = fine_.state_to_change();
    std::vector<std::size_t> parents, returning;
    for (std::size_t i = 0; i < c.size(); ++i) {
        const bool may = c.kind[i] == Kind::fluid || stands_for_finer(c.kind[i]);
        if (!may || c.children[i] == Children::all || outside_coarse_[i] >= guard_over_dp * dp_) continue;
        parents.push_back(i);
        if (c.children[i] == Children::some) returning.push_back(i);
        c.children[i] = Children::all;
    }
    if (parents.empty()) return;
    const auto families = families_of(returning);
    FieldsAt children;
    children.apart = fine_apart;
    std::vector<std::size_t> parent_of, too_many;
    for (const std::size_t i : parents) {
        std::vector<Vec3> places = octants(place_of(c, i));
        if (const auto found = families.find(i); found != families.end()) {
            std::vector<std::size_t> family = found->second;
            const auto from_family = [&](const Vec3& x) {
                double least = std::numeric_limits<double>::infinity();
                for (const std::size_t k : family) least = std::min(least, (place_of(f, k) - x).squaredNorm());
                return least;
            };
            std::ranges::stable_sort(places, std::ranges::greater{}, from_family);
            std::ranges::stable_sort(family, {},
                                     [&](std::size_t k) { return (place_of(f, k) - place_of(c, i)).squaredNorm(); });
            const std::size_t whole = places.size(), there = std::min(family.size(), whole);
            places.resize(whole - there);
            too_many.insert(too_many.end(), family.begin() + static_cast<std::ptrdiff_t>(there), family.end());
        }
        children.places.insert(children.places.end(), places.begin(), places.end());
        parent_of.resize(children.places.size(), i);
    }
    coarse_.interpolate(children);
    for (std::size_t k = 0; k < parent_of.size(); ++k) {
        const Vec3& x = children.places[k];
        const std::size_t i = parent_of[k];
        f.add(x.x(), x.y(), x.z(), 0, 0, fine_.next_id(), zone_.outside(x) < 0 ? Kind::fluid : Kind::guard);
        const bool known = children.given(k).known();
        set_fields(f, f.size() - 1,
                   known ? children.value[k] : VelocityDensityRecord{c.u[i], c.v[i], c.w[i], c.drho[i]});
        f.trend.back().support = known ? children.mean_support[k] : 0;
        ++ledger_.births;
    }
    std::vector<char> gone(f.size(), 0);
    for (const std::size_t k : too_many) gone[k] = 1;
    remove(gone);
    fine_.make_lists_due();
}

void Refinement::remove(const std::vector<char>& gone) {
    std::vector<std::int32_t> kept;
    for (std::size_t i = 0; i < gone.size(); ++i)
        if (!gone[i]) kept.push_back(static_cast<std::int32_t>(i));
    const auto deaths = static_cast<std::int64_t>(gone.size() - kept.size());
    ledger_.deaths += deaths;
    if (deaths == 0) return;
    fine_.state_to_change().reorder(kept);
    fine_.make_lists_due();
}

void Refinement::prolong(double moved, double compressed) {
    const Stopwatch watch(ledger_.seconds);
    const Eigen::Vector3f fall = fine_.body_force().cast<float>();
    const FollowCoarser follow{.excess = excess_,
                               .row = fine_.density_of_row(),
                               .moved = moved,
                               .compressed = compressed,
                               .fall = {fall.x(), fall.y(), fall.z()}};
    const Asking asking{.apart = fine_apart, .without = excess_};
    const Followed guards = fine_.device() ? fine_.device()->follow_coarser(*coarse_.device(), asking, follow)
                                           : follow_coarser(asking, follow);
    ledger_.orphans = guards.orphans;
    // that of the coarse level: of those that are to have children
    in_a_step_ = moved * std::max(coarse_.extremes().speed, std::sqrt(guards.fastest2));
    gone_since_ += in_a_step_;
}

Followed Refinement::follow_coarser(const Asking& asking, FollowCoarser follow) {
    Particles& f = fine_.particles();
    follow.p = fine_.state_view(), follow.trend = f.trend.data();
    const std::vector<std::size_t> who = those(f, [](Kind kind) { return kind == Kind::guard; });
    FieldsAt guards{asking};
    guards.places.resize(who.size());
    Followed followed;
    for (const std::size_t i : who) followed.fastest2 = std::max(followed.fastest2, speed2(follow.p, i));
    for_particles(who.size(), [&](std::size_t k) {
        const V3<double> x = follow.place_ahead(who[k]);
        guards.places[k] = {x.x, x.y, x.z};
    });
    coarse_.interpolate(guards);
    for_particles(who.size(), [&](std::size_t k) { follow(who[k], guards.given(k)); });
    followed.orphans = orphans(guards);
    return followed;
}

void Refinement::restrict_over(double moved, double density_before) {
    const Stopwatch watch(ledger_.seconds);
    const Eigen::Vector3f fall = static_cast<float>(moved) * coarse_.body_force().cast<float>();
    const FollowFiner follow{
        .excess = excess_, .row = coarse_.density_of_row(), .fall = {fall.x(), fall.y(), fall.z()}};
    const Asking asking{.of = Giving::not_guards,
                        .apart = coarse_apart,
                        .density_before = density_before,
                        .want_compression = true,
                        .without = excess_};
    const Followed under = coarse_.device() ? coarse_.device()->follow_finer(*fine_.device(), asking, follow)
                                            : follow_finer(asking, follow);
    ledger_.orphans += under.orphans;
}

Followed Refinement::follow_finer(const Asking& asking, FollowFiner follow) {
    Particles& c = coarse_.particles();
    follow.p = coarse_.state_view(), follow.kind = c.kind.data();
    follow.shift = c.shift_support.data(), follow.compression = c.compression.data();
    const std::vector<std::size_t> who = those(c, stands_for_finer);
    FieldsAt under{asking};
    under.places.resize(who.size());
    for_particles(who.size(), [&](std::size_t k) { under.places[k] = place_of(c, who[k]); });
    fine_.interpolate(under);
    for_particles(who.size(), [&](std::size_t k) { follow(who[k], under.given(k)); });
    return {0, orphans(under)};
}

double Refinement::mass_under() const {
    const Particles& c = coarse().particles();
    std::int64_t under = 0;
    for (std::size_t i = 0; i < c.size(); ++i) under += stands_for_finer(c.kind[i]) && coarse_.between_openings(c.x[i]);
    return coarse_.mass() * double(under);
}

double Refinement::surplus() const {
    const Particles& f = fine().particles();
    std::int64_t water = -ledger_.spray;
    for (std::size_t i = 0; i < f.size(); ++i) water += f.kind[i] != Kind::guard && fine_.between_openings(f.x[i]);
    return fine_.mass() * double(water) - mass_under();
}

double Refinement::mass_drift() const {
    const double mass = mass_under();
    return mass > 0 ? (surplus() - surplus_at_start_) / mass : 0;
}

}  // namespace tw

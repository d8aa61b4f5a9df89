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

Vec3 place_of(const auto& one) { return {one.place.x, one.place.y, one.place.z}; }
Located located(const Particles& p, std::size_t i) { return {static_cast<std::int64_t>(i), {p.x[i], p.y[i], p.z[i]}}; }
std::vector<Located> those_located(const Particles& p, const auto& of) {
    std::vector<Located> found;
    for (std::size_t i = 0; i < p.size(); ++i)
        if (of(i)) found.push_back(located(p, i));
    return found;
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
                .steepest = Zone::steepest,
                .by = shifted_.by,
                .turn = shifted_.turn,
                .pivot = {pivot.x(), pivot.y(), pivot.z()}};
    std::ranges::fill(ask.limits, std::numeric_limits<double>::infinity());
    std::ranges::copy(limits, ask.limits);
    return ask;
}

void Refinement::label_coarse() {
    LabelCoarse label{.band = band_over_dp * dp_, .again = again_over_dp * dp_, .barren = barren_over_dp * dp_};
    const AskEdge ask =
        edge({-band_over_dp * dp_, 0.0, guard_over_dp * dp_, again_over_dp * dp_, barren_over_dp * dp_});
    if (coarse_.device()) return coarse_.device()->label(ask, label, zone_);
    Particles& c = coarse_.particles();
    outside_coarse_.resize(c.size());
    label.kind = c.kind.data(), label.children = c.children.data();
    for_particles(c.size(), [&](std::size_t i) {
        outside_coarse_[i] = ask_edge(ask, zone_, place_of(c, i), c.from_finer_edge[i]);
        label(i, outside_coarse_[i]);
    });
}

DeviceSteps::Spray Refinement::label_fine() {
    LabelFine label{.gone_beyond = gone_over_dp * dp_};
    const AskEdge ask = edge({0.0, gone_over_dp * dp_});
    const Asking asking{.of = Giving::all, .apart = fine_apart};
    if (fine_.device()) return fine_.device()->label(ask, label, zone_, *coarse_.device(), asking);
    Particles& f = fine_.particles();
    std::vector<int> leaves(f.size());
    gone_.resize(f.size());
    label.kind = f.kind.data(), label.leaves = leaves.data(), label.gone = gone_.data();
    std::vector<double> outside(f.size());
    for_particles(f.size(), [&](std::size_t i) {
        outside[i] = ask_edge(ask, zone_, place_of(f, i), f.from_edge[i]);
        label(i, outside[i]);
    });
    FieldsAt leaving{asking};
    std::vector<std::size_t> who;
    for (std::size_t i = 0; i < f.size(); ++i)
        if (leaves[i]) leaving.places.push_back(place_of(f, i)), who.push_back(i);
    coarse_.interpolate(leaving);
    const BecomeGuard become{f.kind.data(), f.trend.data()};
    DeviceSteps::Spray spray;
    for (std::size_t k = 0; k < who.size(); ++k) {
        const std::size_t i = who[k];
        const bool far = outside[i] > label.gone_beyond;
        if (become(i, leaving.given(k))) {
            gone_[i] = far;
            continue;
        }
        ++spray.count;
        if (far) spray.far.push_back(located(f, i));
    }
    return spray;
}

void Refinement::relabel() {
    const Stopwatch watch(ledger_.seconds);
    label_coarse();
    if (!fine_.lists_due() && !fine_.lists_outlived() && gone_since_ + in_a_step_ < patience_over_dp * dp_) return;
    gone_since_ = 0;
    DeviceSteps::Spray spray = label_fine();
    std::vector<std::size_t> fallen;
    for (const Refinement* edge = outer_; edge && !spray.far.empty(); edge = edge->outer_) {
        const std::vector<char> covered = edge->covers(spray.far);
        std::vector<Located> left;
        for (std::size_t k = 0; k < covered.size(); ++k)
            if (covered[k])
                fallen.push_back(static_cast<std::size_t>(spray.far[k].index));
            else
                left.push_back(spray.far[k]);
        spray.far = std::move(left);
    }
    ledger_.spray = spray.count - static_cast<std::int64_t>(fallen.size());
    remove_gone(fallen);
    give_birth();
}

std::vector<char> Refinement::covers(const std::vector<Located>& who) const {
    FieldsAt at{Asking{.of = Giving::all, .apart = fine_apart}};
    for (const Located& one : who) at.places.push_back(place_of(one));
    coarse_.interpolate(at);
    std::vector<char> yes;
    for (const float support : at.support) yes.push_back(support >= BecomeGuard::covered);
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

std::vector<Parent> Refinement::find_parents() {
    const double within = guard_over_dp * dp_;
    if (coarse_.device()) return coarse_.device()->find_parents(within);
    Particles& c = coarse_.particles();
    std::vector<Parent> parents;
    for (std::size_t i = 0; i < c.size(); ++i) {
        if (!Parent::is(c.kind[i], c.children[i], outside_coarse_[i], within)) continue;
        const Located at = located(c, i);
        parents.push_back({at.index, at.place, {c.u[i], c.v[i], c.w[i], c.drho[i]}, c.children[i]});
        c.children[i] = Children::all;
    }
    return parents;
}

std::vector<Located> Refinement::coarse_between(double from, double to) const {
    if (coarse_.device()) return coarse_.device()->between(from, to);
    return those_located(coarse().particles(),
                         [&](std::size_t i) { return outside_coarse_[i] > from && outside_coarse_[i] < to; });
}

std::vector<Located> Refinement::guards() const {
    if (fine_.device()) return fine_.device()->guards();
    const Particles& f = fine().particles();
    return those_located(f, [&](std::size_t i) { return f.kind[i] == Kind::guard; });
}

std::unordered_map<std::int64_t, std::vector<Located>> Refinement::families_of(
    const std::vector<Parent>& parents) const {
    std::unordered_map<std::int64_t, std::vector<Located>> families;
    Crowd crowd(coarse_.setup().dp, coarse_.dimensions());
    for (const Parent& p : parents)
        if (p.before == Children::some) families[p.index], crowd.mark(place_of(p));
    if (families.empty()) return families;
    for (const Located& near : coarse_between(0, band_over_dp * dp_))
        if (crowd.is_marked(place_of(near))) crowd.add(place_of(near), static_cast<std::size_t>(near.index));
    for (const Located& guard : guards()) {
        if (!crowd.is_marked(place_of(guard))) continue;
        const std::optional<std::size_t> parent = crowd.nearest(place_of(guard));
        if (!parent) continue;
        if (const auto family = families.find(static_cast<std::int64_t>(*parent)); family != families.end())
            family->second.push_back(guard);
    }
    return families;
}

void Refinement::give_birth() {
    const std::vector<Parent> parents = find_parents();
    if (parents.empty()) return;
    const auto families = families_of(parents);
    FieldsAt at;
    at.apart = fine_apart;
    std::vector<const Parent*> parent_of;
    std::vector<std::size_t> too_many;
    for (const Parent& parent : parents) {
        std::vector<Vec3> places = octants(place_of(parent));
        if (const auto found = families.find(parent.index); found != families.end()) {
            std::vector<Located> family = found->second;
            const auto from_family = [&](const Vec3& x) {
                double least = std::numeric_limits<double>::infinity();
                for (const Located& k : family) least = std::min(least, (place_of(k) - x).squaredNorm());
                return least;
            };
            std::ranges::stable_sort(places, std::ranges::greater{}, from_family);
            std::ranges::stable_sort(family, {},
                                     [&](const Located& k) { return (place_of(k) - place_of(parent)).squaredNorm(); });
            const std::size_t whole = places.size(), there = std::min(family.size(), whole);
            places.resize(whole - there);
            for (std::size_t k = there; k < family.size(); ++k)
                too_many.push_back(static_cast<std::size_t>(family[k].index));
        }
        at.places.insert(at.places.end(), places.begin(), places.end());
        parent_of.resize(at.places.size(), &parent);
    }
    coarse_.interpolate(at);
    std::vector<Child> children;
    for (std::size_t k = 0; k < parent_of.size(); ++k) {
        const Vec3& x = at.places[k];
        const bool known = at.given(k).known();
        children.push_back({.place = {x.x(), x.y(), x.z()},
                            .state = known ? at.value[k] : parent_of[k]->state,
                            .support = known ? at.mean_support[k] : 0,
                            .kind = zone_.outside(x) < 0 ? Kind::fluid : Kind::guard,
                            .id = fine_.next_id()});
    }
    ledger_.births += static_cast<std::int64_t>(children.size());
    remove_gone(too_many);
    add(children);
    fine_.make_lists_due();
}

void Refinement::add(const std::vector<Child>& children) {
    if (fine_.device()) return fine_.device()->add(children);
    Particles& f = fine_.particles();
    for (const Child& c : children) {
        f.add(c.place.x, c.place.y, c.place.z, c.state.u, c.state.drho, c.id, c.kind);
        f.v.back() = c.state.v, f.w.back() = c.state.w;
        f.trend.back().support = c.support;
    }
}

void Refinement::remove_gone(const std::vector<std::size_t>& more) {
    std::int64_t deaths = 0;
    if (fine_.device()) {
        deaths = fine_.device()->remove_gone(more);
    } else {
        for (const std::size_t i : more) gone_[i] = 1;
        std::vector<std::int32_t> kept;
        for (std::size_t i = 0; i < gone_.size(); ++i)
            if (!gone_[i]) kept.push_back(static_cast<std::int32_t>(i));
        deaths = static_cast<std::int64_t>(gone_.size() - kept.size());
        if (deaths > 0) fine_.particles().reorder(kept);
        gone_.assign(kept.size(), 0);
    }
    ledger_.deaths += deaths;
    if (deaths > 0) fine_.make_lists_due();
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
    const KindCounts of = coarse().kinds();
    return coarse_.mass() * double(of.under() - of.under_beyond);
}

double Refinement::surplus() const {
    const KindCounts of = fine().kinds();
    const std::int64_t water = fine_.count() - of.guards - of.water_beyond - ledger_.spray;
    return fine_.mass() * double(water) - mass_under();
}

double Refinement::mass_drift() const {
    const double mass = mass_under();
    return mass > 0 ? (surplus() - surplus_at_start_) / mass : 0;
}

}  // namespace tw

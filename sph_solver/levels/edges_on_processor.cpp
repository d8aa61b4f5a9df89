// What a level on a processor gives to levels of other sizes, and how its particles follow theirs.
#include <algorithm>

#include "sph_solver/backend/for_particles.h"
#include "sph_solver/levels/on_processor.h"

namespace tw {

namespace {

Vec3 place_at(const Particles& p, std::size_t i) { return {p.x[i], p.y[i], p.z[i]}; }
Located located(const Particles& p, std::size_t i) { return {static_cast<std::int64_t>(i), {p.x[i], p.y[i], p.z[i]}}; }

std::vector<Located> those_located(const Particles& p, const auto& of) {
    std::vector<Located> found;
    for (std::size_t i = 0; i < p.size(); ++i)
        if (of(i)) found.push_back(located(p, i));
    return found;
}

/// The distance from a zone's edge: what is known of it, or worked out again.
double ask_edge(const AskEdge& ask, const Zone& zone, const Vec3& at, EdgeDistance& known) {
    const V3<double> x{at.x(), at.y(), at.z()};
    if (ask.knows(x, known)) return double(known.outside);
    const double outside = zone.outside(at);
    known = ask.found(x, outside);
    return outside;
}

std::int64_t orphans_of(const FieldsAt& at) {
    std::int64_t n = 0;
    for (std::size_t k = 0; k < at.places.size(); ++k) n += !at.given(k).known();
    return n;
}

}  // namespace

// --- who is what
// ------------------------------------------------------------------------------------------------------

void LevelOnProcessor::label(const AskEdge& ask, LabelCoarse label, const Zone& zone) {
    Particles& p = level_.particles;
    outside_.resize(p.size());
    label.kind = p.kind.data(), label.daughters = p.daughters.data();
    for_particles(p.size(), [&](std::size_t i) {
        outside_[i] = ask_edge(ask, zone, place_at(p, i), p.from_finer_edge[i]);
        label(i, outside_[i]);
    });
}

EdgeSteps::Spray LevelOnProcessor::label(const AskEdge& ask, LabelFine label, const Zone& zone, EdgeSteps& coarser,
                                         const Asking& asking) {
    Particles& p = level_.particles;
    std::vector<int> leaves(p.size());
    gone_.resize(p.size());
    label.kind = p.kind.data(), label.leaves = leaves.data(), label.gone = gone_.data();
    std::vector<double> outside(p.size());
    for_particles(p.size(), [&](std::size_t i) {
        outside[i] = ask_edge(ask, zone, place_at(p, i), p.from_edge[i]);
        label(i, outside[i]);
    });
    FieldsAt leaving{asking};
    std::vector<std::size_t> who;
    for (std::size_t i = 0; i < p.size(); ++i)
        if (leaves[i] && share_.owns(i)) leaving.places.push_back(place_at(p, i)), who.push_back(i);
    coarser.interpolate(leaving);
    const BecomeBuffer become{p.kind.data()};
    Spray spray;
    for (std::size_t k = 0; k < who.size(); ++k) {
        const std::size_t i = who[k];
        const bool far = outside[i] > label.gone_beyond;
        if (become(i, leaving.given(k))) {
            gone_[i] = far;
            continue;
        }
        ++spray.count;
        if (far) spray.far.push_back(located(p, i));
    }
    share_.halo().exchange(p.kind.data());
    return spray;
}

std::vector<Located> LevelOnProcessor::between(double from, double to) {
    return those_located(level_.particles,
                         [&](std::size_t i) { return share_.owns(i) && outside_[i] > from && outside_[i] < to; });
}

std::vector<Located> LevelOnProcessor::buffers() {
    const Particles& p = level_.particles;
    return those_located(p, [&](std::size_t i) { return share_.owns(i) && p.kind[i] == Kind::buffer; });
}

void LevelOnProcessor::forget_edge(With whose) {
    Particles& p = level_.particles;
    std::ranges::fill(whose == With::coarser ? p.from_edge : p.from_finer_edge, EdgeDistance{});
}

// --- who comes and goes
// -----------------------------------------------------------------------------------------------

std::vector<Parent> LevelOnProcessor::find_parents(double within) {
    Particles& p = level_.particles;
    std::vector<Parent> parents;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (!Parent::is(p.kind[i], p.daughters[i], outside_[i], within)) continue;
        const Located at = located(p, i);
        if (share_.owns(i))
            parents.push_back({at.index, at.place, {p.u[i], p.v[i], p.w[i], p.drho[i]}, p.daughters[i]});
        p.daughters[i] = Daughters::all;
    }
    return parents;
}

void LevelOnProcessor::add(const std::vector<Child>& daughters) {
    Particles& p = level_.particles;
    if (share_.ranks().many()) share_.let_go({});
    for (const Child& c : daughters) {
        p.add(c.place.x, c.place.y, c.place.z, c.state.u, c.state.drho, c.id, c.kind);
        p.v.back() = c.state.v, p.w.back() = c.state.w;
    }
    share_.own_added();
}

std::int64_t LevelOnProcessor::remove_gone(const std::vector<std::size_t>& more) {
    for (const std::size_t i : more) gone_[i] = 1;
    std::int64_t merges = 0;
    for (std::size_t i = 0; i < gone_.size(); ++i) merges += gone_[i] && share_.owns(i);
    merges = share_.ranks().sum(merges);
    if (merges > 0) share_.let_go(gone_);
    gone_.assign(level_.particles.size(), 0);
    return merges;
}

// --- who follows
// ------------------------------------------------------------------------------------------------------

/// The particles of some kinds that this process owns.
std::vector<std::size_t> LevelOnProcessor::own_of_kind(bool (*of)(Kind)) const {
    const Particles& p = level_.particles;
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < p.size(); ++i)
        if (of(p.kind[i]) && share_.owns(i)) found.push_back(i);
    return found;
}

Followed LevelOnProcessor::follow_coarser(EdgeSteps& coarser, const Asking& asking, FollowCoarser follow) {
    Particles& p = level_.particles;
    follow.p = level_.state_view(), follow.trend = p.trend.data();
    const std::vector<std::size_t> who = own_of_kind([](Kind kind) { return kind == Kind::buffer; });
    FieldsAt buffers{asking};
    buffers.places.resize(who.size());
    Followed followed;
    for (const std::size_t i : who) followed.fastest2 = std::max(followed.fastest2, speed2(follow.p, i));
    for_particles(who.size(), [&](std::size_t k) {
        const V3<double> x = place_ahead(follow.p, who[k], follow.moved);
        buffers.places[k] = {x.x, x.y, x.z};
    });
    coarser.interpolate(buffers);
    for_particles(who.size(), [&](std::size_t k) { follow(who[k], buffers.given(k)); });
    share_.halo().exchange(p.trend.data(), p.drho.data());
    followed.orphans = orphans_of(buffers);
    return share_.ranks().sum(followed);
}

Followed LevelOnProcessor::follow_finer(EdgeSteps& finer, const Asking& asking, FollowFiner follow) {
    Particles& p = level_.particles;
    follow.p = level_.state_view(), follow.kind = p.kind.data();
    follow.shift = p.shift_support.data(), follow.compression = p.compression.data();
    const std::vector<std::size_t> who = own_of_kind(stands_for_finer);
    FieldsAt under{asking};
    under.places.resize(who.size());
    for_particles(who.size(), [&](std::size_t k) { under.places[k] = place_at(p, who[k]); });
    finer.interpolate(under);
    for_particles(who.size(), [&](std::size_t k) { follow(who[k], under.given(k)); });
    share_.halo().exchange(p.u.data(), p.v.data(), p.w.data(), p.drho.data(), p.compression.data());
    return share_.ranks().sum(Followed{0, orphans_of(under)});
}

}  // namespace tw

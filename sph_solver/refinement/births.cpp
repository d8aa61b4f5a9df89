// Children of the coarse particles that come near the zone.
#include <algorithm>
#include <limits>
#include <optional>

#include "sph_solver/refinement/crowd.h"
#include "sph_solver/refinement/refinement.h"

namespace tw {

namespace {
Vec3 place_of(const auto& one) { return {one.place.x, one.place.y, one.place.z}; }
}  // namespace

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

std::unordered_map<std::int64_t, std::vector<Located>> Refinement::families_of(
    const std::vector<Parent>& parents) const {
    std::unordered_map<std::int64_t, std::vector<Located>> families;
    Crowd crowd(coarse_.setup().dp, coarse_.dimensions());
    for (const Parent& p : parents)
        if (p.before == Children::some) families[p.index], crowd.mark(place_of(p));
    if (families.empty()) return families;
    for (const Located& near : coarse_.edges().between(0, band_over_dp * dp_))
        if (crowd.is_marked(place_of(near))) crowd.add(place_of(near), static_cast<std::size_t>(near.index));
    for (const Located& guard : fine_.edges().guards()) {
        if (!crowd.is_marked(place_of(guard))) continue;
        const std::optional<std::size_t> parent = crowd.nearest(place_of(guard));
        if (!parent) continue;
        if (const auto family = families.find(static_cast<std::int64_t>(*parent)); family != families.end())
            family->second.push_back(guard);
    }
    return families;
}

void Refinement::give_birth() {
    const std::vector<Parent> parents = coarse_.edges().find_parents(guard_over_dp * dp_);
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
    fine_.edges().add(children);
    fine_.make_lists_due();
}

void Refinement::remove_gone(const std::vector<std::size_t>& more) {
    const std::int64_t deaths = fine_.edges().remove_gone(more);
    ledger_.deaths += deaths;
    if (deaths > 0) fine_.make_lists_due();
}

}  // namespace tw

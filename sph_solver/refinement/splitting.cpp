// Daughters of the coarse particles that come near the zone.
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
    for (int octant = 0; octant < static_cast<int>(daughters_of_one()); ++octant) {
        const double half = dp_ / 2;
        const Vec3 to(octant & 1 ? half : -half,
                      coarse_.system().around.dimensions == 2 ? 0
                      : octant & 4                            ? half
                                                              : -half,
                      octant & 2 ? half : -half);
        places.push_back(parent + to);
    }
    return places;
}

Refinement::Families Refinement::families_of(const std::vector<Parent>& parents) const {
    Families families;
    std::vector<Located> back, near, buffers;
    for (const Parent& p : parents)
        if (p.before == Daughters::some) back.push_back({p.index, p.place});
    back = coarse_.share().of_all_ranks(std::move(back));
    if (back.empty()) return families;
    Crowd crowd(coarse_.system().setup.dp, coarse_.system().around.dimensions);
    for (const Located& parent : back) families.of[parent.index], crowd.mark(place_of(parent));
    const auto not_marked = [&](const Located& one) { return !crowd.is_marked(place_of(one)); };
    near = coarse_.maker().between(0, overlap_over_dp * dp_);
    std::erase_if(near, not_marked);
    for (const Located& one : coarse_.share().of_all_ranks(std::move(near)))
        crowd.add(place_of(one), static_cast<std::size_t>(one.index));
    buffers = fine_.maker().buffers();
    std::erase_if(buffers, not_marked);
    for (const Located& buffer : fine_.share().of_all_ranks(std::move(buffers))) {
        const std::optional<std::size_t> parent = crowd.nearest(place_of(buffer));
        if (!parent) continue;
        if (const auto family = families.of.find(static_cast<std::int64_t>(*parent)); family != families.of.end())
            family->second.push_back(buffer);
    }
    for (const Located& parent : back) {
        std::vector<Located>& family = families.of[parent.index];
        std::ranges::stable_sort(family, {},
                                 [&](const Located& k) { return (place_of(k) - place_of(parent)).squaredNorm(); });
        for (std::size_t k = daughters_of_one(); k < family.size(); ++k)
            if (const auto own = fine_.share().owned(family[k].index)) families.too_many.push_back(*own);
    }
    return families;
}

void Refinement::split_parents() {
    const std::vector<Parent> parents = coarse_.maker().find_parents(buffer_over_dp * dp_);
    if (coarse_.system().ranks().sum(static_cast<std::int64_t>(parents.size())) == 0) return;
    const Families families = families_of(parents);
    FieldsAt at;
    at.apart = fine_apart;
    std::vector<const Parent*> parent_of;
    std::vector<std::int32_t> by;
    for (const Parent& parent : parents) {
        std::vector<Vec3> places = octants(place_of(parent));
        if (const auto found = families.of.find(coarse_.share().among_all(static_cast<std::size_t>(parent.index)));
            found != families.of.end()) {
            const auto from_family = [&](const Vec3& x) {
                double least = std::numeric_limits<double>::infinity();
                for (const Located& k : found->second) least = std::min(least, (place_of(k) - x).squaredNorm());
                return least;
            };
            std::ranges::stable_sort(places, std::ranges::greater{}, from_family);
            places.resize(places.size() - std::min(found->second.size(), places.size()));
        }
        at.places.insert(at.places.end(), places.begin(), places.end());
        parent_of.resize(at.places.size(), &parent);
        by.resize(at.places.size(), static_cast<std::int32_t>(parent.index));
    }
    coarse_.fields().interpolate(at);
    const RankShare::Numbers numbers = coarse_.share().number_by_pencil(by);
    const std::int64_t first_id = fine_.take_ids(numbers.all);
    std::vector<Child> daughters;
    for (std::size_t k = 0; k < parent_of.size(); ++k) {
        const Vec3& x = at.places[k];
        const bool known = at.given(k).known();
        daughters.push_back({.place = {x.x(), x.y(), x.z()},
                             .state = known ? at.value[k] : parent_of[k]->state,
                             .kind = zone_.outside(x) < 0 ? Kind::fluid : Kind::buffer,
                             .id = first_id + numbers.own[k]});
    }
    ledger_.splits += numbers.all;
    remove_gone(families.too_many);
    fine_.maker().add(daughters);
    fine_.make_lists_due();
}

void Refinement::remove_gone(const std::vector<std::size_t>& more) {
    const std::int64_t merges = fine_.maker().remove_gone(more);
    ledger_.merges += merges;
    if (merges > 0) fine_.make_lists_due();
}

}  // namespace tw

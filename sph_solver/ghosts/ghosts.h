#pragma once
#include <vector>

#include "sph_solver/backend/for_particles.h"
#include "sph_solver/domain/level_setup.h"
#include "sph_solver/domain/surroundings.h"
#include "sph_solver/fields/particles.h"
#include "sph_solver/ghosts/laws.h"
#include "sph_solver/ghosts/link.h"
#include "sph_solver/neighbours/pencils.h"

namespace tw {

/// Particles that a level sees and does not own: the mirror images at slip walls, symmetry planes and periodic faces.
/// They are found when the lists are made, and refreshed at stated moments of an evaluation. In the arrays of the
/// quantities that they have they stand behind the particles.
class Ghosts {
public:
    /// `around` must outlive this.
    Ghosts(const Surroundings& around, const LevelSetup& level, const FixedPoint& fixed_point);

    /// Which particles have images within `reach` [m] of a plane, in the order of the pencils.
    void find(const Particles& particles, const PencilGrid& grid, double reach);

    /// Those that a device has found.
    void take(std::vector<Link> links, std::vector<std::int32_t> start) {
        links_ = std::move(links), start_ = std::move(start);
    }

    /// Gives the images what they have of their sources at time `t`, each quantity by its law: their places, and of
    /// `fields`, which are quantities of `particles`, those that the level has.
    template <class... Fields>
    void refresh(Particles& particles, double t, Fields&... fields) const;
    const std::vector<Link>& links() const { return links_; }
    std::span<const LinkMap> maps() const { return maps_.all(); }
    const Hydrostatic& still() const { return still_; }
    std::size_t count() const { return links_.size(); }
    const std::vector<std::int32_t>& start() const { return start_; }  ///< first image of each pencil
    std::size_t bytes() const { return links_.capacity() * sizeof(Link); }

private:
    template <class T, Law law>
    static T seen_by_law(const FieldOf<T, law>& field, std::size_t i, const LinkMap& map, const HydrostaticLine& line) {
        if constexpr (law == Law::hydrostatic)
            return seen_on(line, field[i], map);
        else
            return seen<law>(field[i], map);
    }

    const Surroundings& around_;
    FixedPoint fixed_point_;
    Hydrostatic still_;
    LinkMaps maps_;
    std::vector<Link> links_;
    std::vector<std::int32_t> start_;
};

template <class... Fields>
void Ghosts::refresh(Particles& p, double t, Fields&... fields) const {
    const std::size_t n = p.size();
    const auto all = [&](const auto& force) {
        for_particles(links_.size(), [&](std::size_t k) {
            const auto i = static_cast<std::size_t>(links_[k].index);
            const LinkMap& map = maps_[links_[k]];
            const PackedPlace &from = p.place[i], &to = p.place[n + k] = seen_place(from, map);
            const V3<double> step = step_to_image(from, to, map, fixed_point_.size);
            const HydrostaticLine line = still_.line(force(i, step), step);
            const auto see = [&](auto& field) {
                if (!field.empty()) field[n + k] = seen_by_law(field, i, map, line);
            };
            (see(fields), ...);
        });
    };
    if (!around_.frame) {
        const Vec3 g = around_.weight();
        return all(SameForce{{g.x(), g.y(), g.z()}});
    }
    all(ForceHalfway{{p.x.data(), p.y.data(), p.z.data(), p.u.data(), p.v.data(), p.w.data(), p.drho.data()},
                     ForceOfFrame::of(around_.force(t))});
}

}  // namespace tw

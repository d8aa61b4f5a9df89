#pragma once
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <unordered_map>
#include <vector>

#include "meshes/zone.h"
#include "sph_solver/levels/level.h"

namespace tw {

/// Two levels of particle size that meet at the edge of a zone, 2:1 in spacing. Pairs are made within each level only;
/// across the edge fields are interpolated (nested levels: Chiron et al. 2018, doi:10.1016/j.jcp.2017.10.041). With s
/// the distance outside the zone, dp the fine spacing:
///
///   fine particles     s < 0 active;  0 <= s: buffer particles, with the coarse level's fields;  gone beyond 5 dp
///   coarse particles   0 <= s active;  -8 dp < s < 0: overlap, deeper: slaves, both with the fine level's fields
///
/// In the uppermost row under a free surface overlap is compressed at the fine level's rate, because the sums of the
/// two sizes differ there; elsewhere by its own, which reflects less sound.
///
/// So the coarse level is whole everywhere: its mass changes at inlet and outlet only. A coarse particle that comes
/// within 4 dp of the zone has four (in three dimensions eight) daughters, buffer particles at first, all of them
/// however near to others: where the flow stretches, parents come near each other in one direction and part in another,
/// and daughters left out for lack of room would be lost mass. One that was 4.1 dp away has as many anew as are missing
/// of the buffer particles that are nearer to it than to other coarse particles (or loses what is too much); one that
/// was 6 dp away, where buffer particles are gone, has all of them. A coarse particle that leaves the zone is active
/// again with the fields that it was given last. Nothing is merged.
///
/// A step of the coarse level comes first, with the overlap moved by its own equations; then two steps of the fine
/// level, with the buffer particles' fields linear in time between the coarse level's; then the fine level's fields go
/// to overlap and slaves. Momentum is not conserved across the edge (to the accuracy of the interpolation only).
///
/// A density is handed over less the excess that the uppermost row of its size has, see surface_excess.h.
///
/// Where the coarse level has no water (Shepard sum below 1/2), what leaves the zone stays active: spray goes on as
/// fine particles until water of the coarse level covers it, or of one that is coarser still: it may fall far beyond
/// the zone of the next coarser size, and the coarsest has particles for all water that is not spray. Where the fine
/// level has none, slave particles fall freely.
class Refinement {
public:
    /// `fine` holds daughters of the particles of `coarse` (see `belongs`). `outer`: the edge at which `coarse` is the
    /// fine level; null: it is the coarsest. All must outlive this.
    Refinement(Level& coarse, Level& fine, Zone zone, const Refinement* outer = nullptr);

    /// Whether a coarse particle there has daughters at the start.
    static bool belongs(const Zone& zone, const Vec3& coarse_place, double fine_dp) {
        return zone.outside(coarse_place) < buffer_over_dp * fine_dp;
    }

    /// Who is what; splits and merges. After the coarse lists are good, before its pair loops. Splits and merges make
    /// the fine level's lists due, so fine particles wait for them until those lists are due anyway, or until particles
    /// may have come so far (3/4 dp) that the innermost would be short of neighbours.
    void relabel();
    /// After the coarse step, which has moved the places by `moved` [s]: what the buffer particles' fields become until
    /// the fine level has moved as far; densities over `compressed` [s], from one evaluation's time to another's.
    void prolong(double moved, double compressed);
    /// After the fine steps: what overlap and slaves become. The coarse density is known `density_before` [s] before
    /// the fine level's.
    void restrict_over(double moved, double density_before);

    const Zone& zone() const { return zone_; }
    /// From the next relabelling on. An edge that comes nearer than a fine spacing a step leaves the buffer particles
    /// whole.
    void set_zone(Zone zone);
    const Level& coarse() const { return coarse_; }
    const Level& fine() const { return fine_; }

    struct Ledger {
        std::int64_t splits = 0, merges = 0;  ///< since the start
        std::int64_t spray = 0;  ///< fine particles that stayed active outside the zone (at the last relabelling)
        std::int64_t orphans =
            0;               ///< overlap, slave and buffer particles without water of the other level near (last step)
        double seconds = 0;  ///< wall time of labels, splits and fields handed over [s]
    };
    const Ledger& ledger() const { return ledger_; }
    void set_ledger(const Ledger& ledger) { ledger_ = ledger; }
    /// Mass of the fine level's particles in the zone less that of the coarse particles under it [kg]. Spray beyond the
    /// zone is not counted: the coarse particles that it belongs to left the zone with the water it came from. Nor is
    /// what is past an outlet, where coarse particles that were there at the start stand for nobody.
    double surplus() const { return surplus(coarse_.fields().kinds(), fine_.fields().kinds()); }
    /// How far the surplus has come from what it was at the start (where a solid cuts the two lattices differently it
    /// is not zero), as a share of the mass of the coarse particles under the zone.
    double mass_drift() const { return mass_drift(coarse_.fields().kinds(), fine_.fields().kinds()); }
    /// The same for who has counted the two levels' particles.
    double mass_drift(const KindCounts& coarse, const KindCounts& fine) const;

private:
    static constexpr double buffer_over_dp = 4, again_over_dp = 4.1, gone_over_dp = 5, barren_over_dp = 6,
                            overlap_over_dp = 8, patience_over_dp = 0.75;
    /// Fine places among coarse particles and coarse ones among fine, in spacings of those.
    static constexpr double fine_apart = 0.5, coarse_apart = 2;

    void label_coarse();
    AskEdge edge(std::initializer_list<double> limits) const;
    EdgeSteps::Spray label_fine();
    void split_parents();
    std::size_t daughters_of_one() const { return coarse_.system().around.dimensions == 3 ? 8 : 4; }
    std::vector<Vec3> octants(const Vec3& parent) const;  ///< places of its daughters
    /// The buffer particles that have one of the parents that come back, of all ranks, nearest of all coarse particles,
    /// and which of the own ones are too many there. Indices are those of RankShare::of_all_ranks.
    struct Families {
        std::unordered_map<std::int64_t, std::vector<Located>> of;
        std::vector<std::size_t> too_many;
    };
    Families families_of(const std::vector<Parent>& parents) const;
    /// Of each of some places whether the coarse level has water there.
    std::vector<char> covers(const std::vector<Located>& who) const;
    void remove_gone(const std::vector<std::size_t>& more);  ///< of the fine particles
    double mass_under(const KindCounts& coarse) const;       ///< of the coarse particles under the zone [kg]
    double surplus(const KindCounts& coarse, const KindCounts& fine) const;

    Level& coarse_;
    Level& fine_;
    const Refinement* outer_;
    Zone zone_;
    Zone::Shift shifted_;  ///< of its edge, sums since the start
    double dp_;            ///< of the fine level
    double in_a_step_ =
        0;  ///< how far buffer particles and coarse particles go in a step of the coarse level, at most [m]
    /// And since fine particles were labelled, with what the edge has come towards them.
    double gone_since_ = std::numeric_limits<double>::infinity();
    SurfaceExcess excess_;  ///< in weights of a row the same for both
    Ledger ledger_;
    double surplus_at_start_ = 0;  ///< [kg]
};

}  // namespace tw

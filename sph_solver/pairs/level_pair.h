#pragma once
#include <cstdint>
#include <vector>

#include "sph_solver/levels/step_maker.h"
#include "sph_solver/neighbours/pencils.h"

namespace tw {

class Level;

/// Two levels that meet: two materials with a surface of contact between them, on particles of the same size. Each
/// level's density gradient, diffusion and walls know nothing of the other. What crosses the surface are the sums that
/// both share, with a pressure and a velocity of the pair that are those of a contact between a heavy and a light fluid
/// (Hu & Adams 2006, doi:10.1016/j.jcp.2005.09.001; Rezavand, Zhang & Hu 2020, doi:10.1016/j.jcp.2019.109092), j in the
/// other level:
///
///   drho_i/dt += rho_i sum_j 2 (u_i - u*) . grad_i W_ij V_j,     u* = (rho_i u_i + rho_j u_j) / (rho_i + rho_j)
///   du_i/dt   -= 1/rho_i sum_j (2 p* + pi_ij) grad_i W_ij V_j,   p* = (rho_j p_i + rho_i p_j) / (rho_i + rho_j)
///
/// with the reference densities. So to the light fluid the heavy one is a wall that moves, and to the heavy fluid the
/// light one is a surface under pressure. The two sums are dual (the work of the one is the energy of the other), and
/// pairs keep momentum except where tension control acts, which keeps stretched gas (p < 0) from clumping. With plain
/// means the light fluid takes the kink of the hydrostatic pressure for a force of hundreds of g: layers at rest boil
/// at 2 m/s. The Shepard sum and the shifting sum count both levels: where the other one is there is no free
/// surface. pi_ij is the artificial viscosity with the harmonic mean of the levels' alpha c rho.
class LevelPair {
public:
    LevelPair(Level& a, Level& b) : a_(a), b_(b) {}

    /// Since both lists were made the particles may have come as near to each other as those lists bear.
    bool lists_outlived() const;
    /// Anew after both levels have been sorted.
    void find_neighbours();
    /// Before the first pair loops, as of the time t: the sums of each level over the other.
    void meet(double t);
    /// After the second pair loops: adds to the rates of both.
    void press(double t);
    /// Over the other level, one entry for each particle of `level`, where its steps are made; null when the pair does
    /// not hold it.
    const OtherSums* sums_for(const Level& level) const;
    std::size_t bytes() const;

private:
    struct Side {
        Level* level;
        StepMaker::Near near;  ///< those of the level's clusters that have the other one within reach
        StepMaker::RoomForLists room;
        LoopArray<OtherSums> sums;
        explicit Side(Level& of) : level(&of) {}
    };
    Side a_, b_;
};

}  // namespace tw

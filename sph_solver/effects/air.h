#pragma once
#include <vector>

#include "sph_solver/neighbours/columns.h"
#include "sph_solver/backend/pass_data.h"

namespace tw {

class Solver;
struct SolverSetup;

/// Air as a second phase: a gas of its own density and sound speed, on particles of the water's spacing,
///
///   p = rho_a c_a^2 / gamma ((rho / rho_a)^gamma - 1),   rho_a c_a^2 = gamma p_atm with the real 343 m/s.
///
/// Each phase is a delta-SPH fluid of its own (Solver): its density gradient, its diffusion and its walls know nothing
/// of the other. What crosses the interface are the sums that both share, with a pressure and a velocity of the pair
/// that are those of a contact between a heavy and a light fluid (Hu & Adams 2006, doi:10.1016/j.jcp.2005.09.001;
/// Rezavand, Zhang & Hu 2020, doi:10.1016/j.jcp.2019.109092), j in the other phase:
///
///   drho_i/dt += rho_i sum_j 2 (u_i - u*) . grad_i W_ij V_j,     u* = (rho_i u_i + rho_j u_j) / (rho_i + rho_j)
///   du_i/dt   -= 1/rho_i sum_j (2 p* + pi_ij) grad_i W_ij V_j,   p* = (rho_j p_i + rho_i p_j) / (rho_i + rho_j)
///
/// with the phases' reference densities. So to the air the water is a wall that moves, and to the water the air is a
/// surface under pressure. The two sums are dual (the work of the one is the energy of the other), and pairs keep
/// momentum but where tension control acts, which keeps stretched air (p < 0) from clumping. With plain means the air
/// takes the kink of the hydrostatic pressure for a force of hundreds of g: layers at rest boil at 2 m/s.
/// The kernel support and the shifting sum count both phases: where there is air there is no free surface. pi_ij is the
/// artificial viscosity with the harmonic mean of the phases' alpha c rho. Other effects act on the water alone.
/// The gas is shut in: what breaking water's particles lose in order they gain in volume, and the gas bears it (2 % of
/// the gas are 3 kPa). So sampled pressures are relative to the lid's, as if the top were open.
/// The gas sets the time step: its sound is four times faster than a typical numerical sound of water.
struct AirOptions {
    double density = 1.2;          ///< rho_a [kg/m3]
    double sound_speed = 343;      ///< c_a [m/s]
    double heat_capacities = 1.4;  ///< gamma
};
/// The gas on its own in the water's domain.
SolverSetup air_setup(SolverSetup water, const AirOptions& air);

/// Kinetic, potential and elastic energy [J], with x = rho/rho_a per mass
///   int p / rho^2 drho = c_a^2/gamma (x^(gamma-1)/(gamma-1) + 1/x - gamma/(gamma-1)).
double gas_energy(const Solver& gas);

/// One phase as the interface sees it. Indices of `pass` run over its particles, then its mirror images.
struct PhaseView {
    const PassData& pass;
    const std::vector<Group>& groups;
    std::size_t count;  ///< of particles
    const std::vector<std::int32_t>&start, &image_start;
};

/// The neighbours of one phase in the other, and what they do to it.
class Interface {
public:
    /// Anew after both phases have been sorted; good until the particles have come `reach` less the kernel's support
    /// nearer.
    void find_neighbours(const Passes& passes, const ColumnGrid& grid, const Quanta& quanta, const PhaseView& own, const PhaseView& other,
                         double reach);
    /// Before the first sweep of `own`: its `other` sums.
    void meet(const Passes& passes, const PassData& own, const PassData& other);
    /// After the second sweep of both: adds to the rates of `own`.
    void press(const Passes& passes, const PassData& own, const PassData& other) const;
    const OtherSums* sums() const { return sums_.data(); }
    std::size_t bytes() const;

private:
    std::vector<Group> groups_;  ///< those that have the other phase within reach
    NeighbourLists lists_;
    std::vector<OtherSums> sums_;
};

}  // namespace tw

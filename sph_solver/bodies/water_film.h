#pragma once
#include <vector>

#include "meshes/surface.h"
#include "motion/rigid_body.h"
#include "motion/wall_contact.h"
#include "sph_solver/bodies/load.h"
#include "sph_solver/bodies/samples.h"

namespace tw {

/// Water between a body and a wall of the tank that it stands on, where no particle fits: a film in a gap of even
/// width. Slow or sudden, viscous or not, its pressure without the weight of the water is harmonic over the faces at
/// the wall, and that of the water round them is its boundary value (Reynolds 1886 for a viscous film, and of an
/// inviscid one div du/dt = -lap p / rho0 = 0 across the gap):
///
///   lap (p - rho0 f . x) = 0 at the wall,   p = 0 where the rim is dry,   p >= 0
///
/// Between a wet and a dry rim p falls linearly, which is the uplift that dams and caissons on a bed are designed for
/// (Goda 1974, doi:10.1061/9780872621138.103). All round in still water it is that of the depth, so Archimedes lifts a
/// body that stands on the floor. Left out: what it takes to fill the gap when it opens, its added mass.
///
/// So near a wall the force on the body is the integral of the pressure on its whole surface, the film's and that which
/// is sampled from particles; the pair forces miss what the particles' images behind the wall do to it. It replaces
/// those within one spacing of the wall, and does no more beyond two. The faces are patches of about dp, however finely
/// the surface is triangulated; lap is the graph Laplacian of neighbours with weights 1 / r^2.
class WaterFilm {
public:
    WaterFilm(const Surface& surface, int dimensions, double dp);

    /// How much of the body's load is by this, by its distance from the walls [m]: one to none.
    double share(double gap) const;
    /// Where pressure and support are asked for, with the body as it is now.
    std::vector<Vec3> places(const RigidBody& body) const;
    /// Force and moment about the body's centre of mass, from the samples at those places. `weight`: rho0 f [N/m3].
    Load load(const RigidBody& body, const WallContact& walls, const PointSamples& samples, const Vec3& weight) const;

private:
    struct Neighbour {
        std::size_t patch;
        double weight;  ///< [1/m2]
    };
    /// One patch for all small ones of a cell that face about the same way: with neighbours within a length their number
    /// squared would count.
    void merge_small();
    void find_neighbours();
    /// Lets the heads of the patches in `film` be the mean of their neighbours'; of dry ones that of no pressure where
    /// the patch of the film itself is.
    void settle(const std::vector<std::size_t>& film, const std::vector<double>& dry_head, const std::vector<char>& wet,
                std::vector<double>& head) const;

    double dp_;
    std::vector<Vec3> at_start_, area_;  ///< of the patches, outward [m], [m2]
    std::vector<std::vector<Neighbour>> beside_;
};

}  // namespace tw

#pragma once
#include <vector>

#include "motion/rigid_body.h"

namespace tw {

/// A rigid wall: a body stays where normal . x >= offset.
struct WallPlane {
    Vec3 normal = Vec3::UnitZ();  ///< into the tank, of length one [-]
    double offset = 0;            ///< [m]
};

/// Impulse of walls on a body [N s], and its moment about the body's centre of mass [N m s].
struct WallReaction {
    Vec3 impulse = Vec3::Zero(), turn = Vec3::Zero();  ///< [N s], [N m s]
};

/// Contact of a free rigid body with walls: it does not go through them (Signorini), gives no rebound, and slides against
/// Coulomb friction. A polyhedron meets a plane by its corners; at each of them, with the velocity u at the end of a kick
/// and the impulse r of the wall, gap g and time `ahead` for which the velocity will carry the body,
///
///   0 <= r_n,   u_n + g / ahead >= 0,   r_n (u_n + g / ahead) = 0
///   |r_t| <= mu r_n,   and where the corner slides r_t = -mu r_n u_t / |u_t|
///
/// (Moreau 1988, doi:10.1007/978-3-7091-2624-0_1; Stewart & Trinkle 1996, doi:10.1002/(SICI)1097-0207(19960815)39:15<2673::
/// AID-NME972>3.0.CO;2-I). All corners are solved together by projected Gauss-Seidel iteration in their given order
/// (Jourdan, Alart & Jean 1998, doi:10.1016/S0045-7825(97)00174-9). The law holds at the level of impulses, so it needs no
/// stiffness and allows any time step; what rests, rests; where several corners carry the body the forces on each are not
/// unique, their sum and moment are. What has sunk in by rounding is let out in about ten steps.
///
/// Water does not get out of a gap narrower than its particles. So a body that has once been clear of a wall by `room`
/// afterwards comes to rest that far from it, on what is left there (as tyres do, decision 038); one that starts on the
/// wall stands on it.
///
/// Motions that are locked carry what the walls give along them: a corner that no free motion moves across a wall has no
/// reaction there, and no friction either.
class WallContact {
public:
    /// `corners`: of the body as it stands at the start [m]; `friction`: Coulomb's mu [-].
    WallContact(std::vector<Vec3> corners, std::vector<WallPlane> walls, double friction);

    /// The reaction that keeps the body out of the walls for the time `ahead` [s] from now on; it is applied to the body.
    WallReaction resist(RigidBody& body, double ahead);
    void keep_room(double room) { room_ = room; }  ///< [m]; none: it comes to rest on the walls
    const std::vector<WallPlane>& walls() const { return walls_; }
    bool at(const Vec3& normal) const;  ///< whether there is a wall of this normal
    /// From the walls to the nearest corner, negative in a wall; infinite without walls [m].
    double gap(const RigidBody& body) const;

    /// For each wall whether the body has been clear of it.
    const std::vector<bool>& cleared() const { return cleared_; }
    void set_cleared(std::vector<bool> cleared) { cleared_ = std::move(cleared); }

private:
    double gap_to(const WallPlane& wall, const RigidBody& body) const;
    void note_clear(const RigidBody& body);

    std::vector<Vec3> corners_;
    Vec3 middle_ = Vec3::Zero();  ///< of the corners [m]
    double reach_ = 0;            ///< from there to the farthest one [m]
    std::vector<WallPlane> walls_;
    double friction_, room_ = 0;
    std::vector<bool> cleared_;
};

}  // namespace tw

#pragma once
#include <vector>

#include "base/vec3.h"

namespace tw {

/// What water does at the faces of a solid; both methods take it from here.
class WetWall {
public:
    /// A face with its outward area vector [m2] and the pressure of the water on it above the air's [Pa]. `wet`: water
    /// stands at it. `gap`: between it and the water, in particle spacings or cells; 1 or more where there is none
    /// near.
    void add(const Vec3& area, double pressure, bool wet, double gap);

    /// Of the wet faces where the pressure is below the air's [m2].
    double suction_area() const { return suction_area_; }
    /// Sum of -pressure area over those, whatever the direction [N].
    double suction_force() const { return suction_force_; }
    /// The angle from straight down at which water leaves a solid that comes down into it [rad]. The faces that look
    /// down most steeply, up to an angle between their outward normal and straight down, have as much area as the water
    /// is near to: where it wets a round body up to some line this is the angle of that line, whatever single faces
    /// are; of a wedge it is that of the sides that are wet. Near is a matter of the spacing, and a free streamline
    /// that leaves a curved wall smoothly goes away from it as s^(5/2) (Brillouin 1911, Villat 1914; the curvature is
    /// the wall's at first), so that water within half a spacing is found 15 to 25 degrees beyond where it has left.
    /// The angle is therefore that at gap 0 by this law, from those at two gaps. 0: dry; pi: wet all round. Water that
    /// meets a wall squarely, as at a body at rest, is found up to 1.5 spacings too low.
    double leaving_angle() const;

private:
    /// Up to which the faces that look down most steeply have as much area as those with a gap up to `gap` [rad].
    double angle_within(double gap) const;

    struct Face {
        double down;  ///< cosine of the angle between the outward normal and straight down [-]
        double area;  ///< [m2]
        double gap;   ///< [rad]
    };
    std::vector<Face> faces_;
    double suction_area_ = 0, suction_force_ = 0;
};

}  // namespace tw

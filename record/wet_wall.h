#pragma once
#include <vector>

#include "base/vec3.h"

namespace tw {

/// What water does at the faces of a solid; both methods take it from here.
class WetWall {
public:
    /// A face with its outward area vector [m2] and the pressure of the water on it above the air's [Pa]. `wet`: water
    /// stands at it.
    void add(const Vec3& area, double pressure, bool wet);

    /// Of the wet faces where the pressure is below the air's [m2].
    double suction_area() const { return suction_area_; }
    /// Sum of -pressure area over those, whatever the direction [N].
    double suction_force() const { return suction_force_; }
    /// The angle from straight down at which water leaves a solid that comes down into it [rad]: the faces that look
    /// down most steeply, up to this angle between their outward normal and straight down, have as much area as is wet.
    /// Where water wets a round body up to some line this is the angle of that line, whatever single faces are; of a
    /// wedge it is that of the sides that are wet. 0: dry; pi: wet all round. A sheet that leaves a cylinder of radius R
    /// along its tangent is within a distance d of the wall for another sqrt(2 d / R): with what is half a spacing away
    /// taken as wet, that is 12 degrees at 44 spacings in the diameter and 17 at 22.
    double leaving_angle() const;

private:
    struct Face {
        double down;  ///< cosine of the angle between the outward normal and straight down
        double area;  ///< [m2]
    };
    std::vector<Face> faces_;
    double wet_area_ = 0, suction_area_ = 0, suction_force_ = 0;
};

}  // namespace tw

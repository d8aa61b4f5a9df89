#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "meshes/first_hit.h"
#include "spray/air/air.h"
#include "spray/flight/drag.h"

namespace tw::spray {

/// A surface that stops droplets.
struct Target {
    std::string name;
    const FirstHit* surface;
};

enum class Fate {
    flying,     ///< still in the air at the end of the time
    hit,        ///< met a target
    fell_back,  ///< met the water's surface
    left_air    ///< left what the air field covers: nothing is known from there on
};
const char* to_string(Fate fate);

/// How a droplet's flight ended.
struct Landing {
    Fate fate = Fate::flying;
    double time = 0;  ///< [s]
    Vec3 place = Vec3::Zero(), velocity = Vec3::Zero();
    int target = -1, triangle = -1;  ///< of a hit
    double normal_speed = 0;         ///< of a hit: towards the surface [m/s], above 0
    double angle = 0;                ///< of a hit: between path and surface [rad], pi/2 is square on
};

struct FlightOptions {
    double end_time = 1;          ///< [s]
    double tolerance = 1e-6;      ///< of a step, relative to speed and to the way flown in a relaxation time [-]
    bool falls_back = true;       ///< stop at the water's surface
    double water_level = 0;       ///< z of that surface [m]
    double water_density = 1000;  ///< [kg/m3]
    Forces forces;
    double sample = 0;  ///< time between places handed to the visitor [s]; 0: none
};

/// Gets droplet number, time, place and velocity at every multiple of `sample`, from several threads at once.
using Visitor = std::function<void(std::size_t droplet, double time, const Vec3& place, const Vec3& velocity)>;

/// Flies every droplet from its own time to `end_time` by the embedded method of Dormand & Prince (1980, order 5(4),
/// doi:10.1016/0771-050X(80)90013-3) with its continuous output, on all threads of OpenMP. Where the path comes near a
/// target, the continuous output is cut into chords that stay within 1e-5 of the target's size of it, and the hit is
/// moved to where the curve itself meets the triangle's plane. A droplet of relaxation time tau takes at least
/// t / (3 tau) steps, so mist below 20 micrometres is slow.
/// Throws InputError naming the droplet: diameter not above 0, place or velocity not finite.
std::vector<Landing> fly(std::span<const Droplet> droplets, const Air& air, std::span<const Target> targets,
                         const FlightOptions& options, const Visitor& visitor = {});

}  // namespace tw::spray

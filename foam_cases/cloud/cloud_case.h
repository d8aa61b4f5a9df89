#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/vec3.h"
#include "foam_cases/openfoam.h"

namespace tw {

/// One sphere of liquid of an OpenFOAM cloud, let go at time 0.
struct Parcel {
    Vec3 place = Vec3::Zero();     ///< [m]
    Vec3 velocity = Vec3::Zero();  ///< [m/s]
    double diameter = 0;           ///< [m]
};

/// Spheres that fly through steady air of one density and viscosity, without an effect on it or on each other: a case
/// of icoUncoupledKinematicParcelFoam with the forces sphereDrag and gravity. Its drag coefficient is Putnam's,
///
///   Cd = 24 / Re (1 + Re^(2/3) / 6)   Re <= 1000        Cd = 0.424   above
///
/// and its gravity is always that of the sphere less the air's buoyancy. What meets a side of the room has left.
struct CloudCase {
    std::vector<Parcel> parcels;
    double liquid_density = 1000;                         ///< [kg/m3]
    double air_density = 1.225;                           ///< [kg/m3]
    double air_kinematic_viscosity = 1.48e-5;             ///< [m2/s]
    Vec3 wind = Vec3::Zero();                             ///< [m/s], where air_velocity is not given
    std::function<Vec3(const Vec3& place)> air_velocity;  ///< asked at the centres of the cells
    Vec3 gravity{0, 0, -9.81};                            ///< [m/s2]
    bool buoyancy = true;     ///< false: gravity is raised by 1 / (1 - air_density / liquid_density), which undoes it
    Box room;                 ///< [m], holds all paths
    double duration = 1;      ///< [s]
    double time_step = 1e-3;  ///< [s]
    int frames = 10;          ///< written, the last at `duration`
};

/// A parcel as OpenFOAM has written it.
struct ParcelState {
    std::size_t parcel = 0;  ///< place in CloudCase::parcels
    double age = 0;          ///< [s] since it was let go: OpenFOAM spreads injections over its first step
    Vec3 place = Vec3::Zero(), velocity = Vec3::Zero();  ///< [m], [m/s]
};

inline constexpr const char* cloud_solver = "icoUncoupledKinematicParcelFoam";

/// Writes the case. Throws InputError: no parcels, a parcel outside the room, sizes and times that are not above 0.
void write_cloud_case(const CloudCase& cloud, const std::filesystem::path& folder);
/// The first installation, sound ones before others, that has `cloud_solver`. The fault that the self-test of
/// interFoam looks for does not touch parcels.
std::optional<OpenFoam> openfoam_with_cloud_solver();
/// blockMesh and the solver. Throws RunError with the program's own message.
void run_cloud_case(const OpenFoam& openfoam, const std::filesystem::path& folder);
/// What was written after time 0, in the order of times; a frame without parcels is empty. Throws RunError naming the
/// file: not there, or cut off.
std::vector<std::vector<ParcelState>> read_cloud(const std::filesystem::path& folder);

}  // namespace tw

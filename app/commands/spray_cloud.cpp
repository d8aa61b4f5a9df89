#include "app/commands/spray_cloud.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/arguments/output.h"
#include "base/errors.h"
#include "foam_cases/cloud/cloud_case.h"
#include "spray/flight/tracks.h"

namespace tw::app {
namespace {

using namespace spray;

/// OpenFOAM moves a parcel by its velocity at the step's begin, half a step of its change of speed too far: a 2000th of
/// the flight and a fiftieth of a relaxation time leave about 0.1 % of the way. No more than 20000 steps, however small
/// the smallest droplet.
double cloud_time_step(double duration, double relaxation) {
    return std::max(std::min(duration / 2000, relaxation / 50), duration / 20000);
}

AirState air_at(const Air& air, const Vec3& place) {
    AirState state;
    if (!air.at(place, state))
        throw InputError(
            fmt::format("OpenFOAM cloud: the air field does not cover ({:.3g}, {:.3g}, {:.3g}) m; expected all of the "
                        "box round the flights. Widen it, or fly for a shorter time",
                        place.x(), place.y(), place.z()));
    return state;
}

CloudCase cloud_of(const SprayStudy& study, std::span<const Droplet> droplets, const FlightOptions& flight) {
    CloudCase cloud;
    for (const Droplet& d : droplets) cloud.parcels.push_back({d.place, d.velocity, d.diameter});
    const AirState air = air_at(*study.air, droplets.front().place);
    const auto same_air = [air](const AirState& other) {
        if (other.density != air.density || other.viscosity != air.viscosity)
            throw InputError(
                fmt::format("OpenFOAM cloud: its solver knows one density and viscosity of the air; found "
                            "{:g} and {:g} kg/m3",
                            air.density, other.density));
    };
    for (const Droplet& d : droplets) same_air(air_at(*study.air, d.place));
    cloud.liquid_density = flight.water_density;
    cloud.air_density = air.density;
    cloud.air_kinematic_viscosity = air.viscosity / air.density;
    cloud.wind = air.velocity;
    if (!dynamic_cast<const UniformAir*>(study.air.get()))
        cloud.air_velocity = [&field = *study.air, same_air](const Vec3& place) {
            const AirState here = air_at(field, place);
            same_air(here);
            return here.velocity;
        };
    cloud.gravity = flight.forces.gravity;
    cloud.buoyancy = flight.forces.buoyancy;
    cloud.duration = flight.end_time;
    cloud.time_step = cloud_time_step(flight.end_time, shortest_relaxation(droplets, *study.air, flight));
    cloud.room = room_of_flights(droplets, *study.air, flight);
    // No path may touch a side, also one of OpenFOAM's that is a little off. Where the air is a field that has to cover
    // the cells' centres the margin is less than half a cell.
    const double share = cloud.air_velocity ? 0.02 : 0.1;
    const Vec3 margin = Vec3::Constant(share * cloud.room.size().maxCoeff() + 1e-4);
    cloud.room.min -= margin, cloud.room.max += margin;
    return cloud;
}

std::vector<std::vector<TrackPoint>> tracks_of(const std::filesystem::path& folder) {
    std::vector<std::vector<TrackPoint>> frames;
    for (const auto& frame : read_cloud(folder)) {
        auto& points = frames.emplace_back();
        for (const ParcelState& p : frame) points.push_back({p.parcel, p.age, p.place, p.velocity});
    }
    return frames;
}

}  // namespace

ReportTable fly_in_openfoam(const SprayStudy& study, const SprayResult& result, const std::filesystem::path& folder) {
    if (result.droplets.empty()) throw InputError("OpenFOAM cloud: no droplet was taken, so there is none to write");
    if (std::filesystem::exists(folder) && !std::filesystem::is_empty(folder))
        throw InputError(folder.string() + ": exists already and is not empty; choose a new folder");
    FlightOptions flight = flight_of(study);
    flight.end_time = study.duration;
    const CloudCase cloud = cloud_of(study, result.droplets, flight);
    make_folder(folder);
    leaving_files([&] { write_cloud_case(cloud, folder); });

    ReportTable table{"Trajectories of OpenFOAM's cloud against these",
                      {words("drag here"), numbers("age up to", "s"), numbers("droplets", "", 9),
                       numbers("largest difference", "% of the way", 3), numbers("root mean square", "% of the way", 3),
                       numbers("of the speed", "%", 3), numbers("worst droplet", "", 9)}};
    const auto openfoam = openfoam_with_cloud_solver();
    if (!openfoam) {
        table.notes.push_back(
            fmt::format("{}: written and not run, as no OpenFOAM with {} was found.", folder.string(), cloud_solver));
        return table;
    }
    run_cloud_case(*openfoam, folder);
    const auto frames = tracks_of(folder);
    for (const auto& [law, name] :
         {std::pair{study.flight.forces.drag, "as in the study"}, {DragLaw::putnam, "Putnam's, as OpenFOAM's"}}) {
        flight.forces.drag = law;
        for (const TrackDifference& d : compare_tracks(result.droplets, frames, *study.air, flight))
            table.rows.push_back({{name, d.age, d.points, 100 * d.largest, 100 * std::sqrt(d.mean_square),
                                   100 * d.largest_speed, d.worst + 1}});
    }
    table.notes.push_back(fmt::format("{}, {} {}, {} parcels, time step {:.3g} s.", folder.string(), openfoam->vendor,
                                      openfoam->version, cloud.parcels.size(), cloud.time_step));
    return table;
}

}  // namespace tw::app

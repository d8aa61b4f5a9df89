#include "spray/flight/tracks.h"

#include <fmt/format.h>

#include <limits>
#include <mutex>

#include "base/errors.h"

namespace tw::spray {

std::vector<TrackDifference> compare_tracks(std::span<const Droplet> droplets,
                                            std::span<const std::vector<TrackPoint>> frames, const Air& air,
                                            FlightOptions options) {
    struct SoFar {
        Vec3 place;
        double age = 0, way = 0, speed = 0;
    };
    std::vector<SoFar> so_far;
    for (const Droplet& d : droplets) so_far.push_back({d.place, 0, 0, d.velocity.norm()});
    options.end_time = 0;
    options.sample = 0;
    std::vector<TrackDifference> differences;
    for (const std::vector<TrackPoint>& frame : frames) {
        std::vector<Droplet> aged;  // let go so long before time 0
        for (const TrackPoint& p : frame) {
            if (p.droplet >= droplets.size())
                throw InputError(fmt::format("tracks: droplet {} of {}", p.droplet + 1, droplets.size()));
            if (!(p.age > so_far[p.droplet].age))
                throw InputError(fmt::format("tracks: droplet {} has an age of {:g} s after {:g} s; expected more",
                                             p.droplet + 1, p.age, so_far[p.droplet].age));
            aged.push_back(droplets[p.droplet]);
            aged.back().time = -p.age;
        }
        const std::vector<Landing> ours = fly(aged, air, {}, options);
        TrackDifference& d = differences.emplace_back();
        for (std::size_t i = 0; i < frame.size(); ++i) {
            const TrackPoint& p = frame[i];
            if (ours[i].fate != Fate::flying) continue;
            SoFar& s = so_far[p.droplet];
            s.way += (ours[i].place - s.place).norm();
            s.speed = std::max(s.speed, ours[i].velocity.norm());
            s.place = ours[i].place;
            s.age = p.age;
            ++d.points;
            d.age = std::max(d.age, p.age);
            const double off = (p.place - s.place).norm() / s.way;
            if (!(off <= d.largest)) d.largest = off, d.worst = p.droplet;
            d.mean_square += off * off;
            d.largest_speed = std::max(d.largest_speed, (p.velocity - ours[i].velocity).norm() / s.speed);
        }
        if (d.points > 0) d.mean_square /= static_cast<double>(d.points);
    }
    return differences;
}

Box room_of_flights(std::span<const Droplet> droplets, const Air& air, FlightOptions options) {
    std::vector<Droplet> own_clock(droplets.begin(), droplets.end());
    for (Droplet& d : own_clock) d.time = 0;
    Box room{Vec3::Constant(std::numeric_limits<double>::infinity()),
             Vec3::Constant(-std::numeric_limits<double>::infinity())};
    const auto take_in = [&room](const Vec3& place) {
        room.min = room.min.cwiseMin(place), room.max = room.max.cwiseMax(place);
    };
    std::mutex one_at_a_time;
    options.sample = options.end_time / 200;
    const auto ends = fly(own_clock, air, {}, options, [&](std::size_t, double, const Vec3& place, const Vec3&) {
        const std::lock_guard lock(one_at_a_time);
        take_in(place);
    });
    for (const Landing& l : ends) take_in(l.place);
    for (const Droplet& d : droplets) take_in(d.place);
    return room;
}

double shortest_relaxation(std::span<const Droplet> droplets, const Air& air, const FlightOptions& options) {
    Forces drag_alone = options.forces;
    drag_alone.gravity = Vec3::Zero();
    double shortest = std::numeric_limits<double>::infinity();
    for (const Droplet& d : droplets) {
        AirState here;
        if (!air.at(d.place, here)) continue;
        const Vec3 slip = d.velocity - here.velocity;
        const bool above = sphere_reynolds(slip.norm(), d.diameter, here) > Re_of_the_jump;
        const Vec3 a = acceleration(d.velocity, d.diameter, here, options.water_density, drag_alone, above);
        if (a.norm() > 0) shortest = std::min(shortest, slip.norm() / a.norm());
    }
    return shortest;
}

}  // namespace tw::spray

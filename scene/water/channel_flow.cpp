#include "scene/water/channel_flow.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/water/tailwater.h"

namespace tw {
namespace {

constexpr double noticed = 0.02;  ///< of the energy ahead, or of what a gate lets through

/// A stream as it comes.
struct Coming {
    double depth, speed, gravity;
    double q() const { return depth * speed; }
    double energy() const { return specific_energy(depth, speed, gravity); }
    bool is_slow() const { return speed * speed < gravity * depth; }
};

/// Whether it leaves no way round.
bool reaches_across(const Obstacle& obstacle, const Scene& scene) {
    const Box &at = obstacle.surface.bounds(), &box = scene.domain.as_asked;
    const double clear = scene.resolution.near_hull;
    return scene.domain.dimensions == 2 || (at.min.y() < box.min.y() + clear && at.max.y() > box.max.y() - clear);
}

/// The depth above the critical one with this energy, by Newton's steps from above: the function is convex there [m].
double slow_depth(double energy, double q, double gravity) {
    double h = energy;
    for (int step = 0; step < 100; ++step) {
        const double more = h + q * q / (2 * gravity * h * h) - energy, slope = 1 - q * q / (gravity * h * h * h);
        if (!(slope > 0)) break;
        h -= more / slope;
        if (std::abs(more) < 1e-12 * energy) break;
    }
    return h;
}

std::string what_to_do(const Coming& c, double energy) {
    return c.is_slow() ? fmt::format(
                             "the water ahead will rise from {:.4g} to {:.4g} m, where the inlet lets it in {:.4g} m "
                             "deep; expected that depth, or less speed",
                             c.depth, slow_depth(energy, c.q(), c.gravity), c.depth)
                       : std::string(
                             "it will not pass as fast as it comes: a jump forms ahead and runs to the inlet; expected "
                             "more speed, or less in its way");
}

void warn(std::vector<Finding>& findings, const char* name, std::string message) {
    findings.push_back({.level = Finding::Level::warning, .name = name, .message = std::move(message)});
}

void judge_weir(const Obstacle& o, double height, const Coming& c, std::vector<Finding>& findings) {
    const double needed = height + 1.5 * critical_depth(c.q(), c.gravity);
    if (c.energy() > (1 - noticed) * needed) return;
    warn(findings, "choked",
         fmt::format("over {}, {:.4g} m high, {:.4g} m2/s need {:.4g} m of energy head (the critical depth there), and "
                     "the stream has {:.4g} m: {}",
                     o.name, height, c.q(), needed, c.energy(), what_to_do(c, needed)));
}

void judge_gate(const Obstacle& o, double opening, const Coming& c, bool leaves_fast, std::vector<Finding>& findings) {
    if (!(opening < c.depth)) return;
    const double jet = contraction_of_gate * opening, most = through_gate(opening, c.energy(), c.gravity);
    const double needed = jet + std::pow(c.q() / jet, 2) / (2 * c.gravity);
    if (c.q() > (1 + noticed) * most)
        warn(findings, "choked",
             fmt::format("under {}, {:.4g} m above the bed, at most {:.4g} m2/s pass (contraction {:g}), and {:.4g} "
                         "come: {}",
                         o.name, opening, most, contraction_of_gate, c.q(), what_to_do(c, needed)));
    else if (leaves_fast && c.is_slow() && c.q() < (1 - noticed) * most)
        warn(findings, "gate_too_wide",
             fmt::format("under {}, {:.4g} m above the bed, {:.4g} m2/s pass freely (contraction {:g}), and {:.4g} "
                         "come: the water ahead will sink from {:.4g} to {:.4g} m; expected that depth, or more speed",
                         o.name, opening, most, contraction_of_gate, c.q(), c.depth,
                         slow_depth(needed, c.q(), c.gravity)));
}

void judge_jump(const Tailwater& tail, const Coming& c, std::vector<Finding>& findings) {
    const double conjugate = conjugate_depth(c.depth, c.speed, c.gravity);
    if (std::abs(tail.depth - conjugate) <= 0.01 * conjugate) return;
    warn(findings, "jump_moves",
         fmt::format("the jump in this channel stands where the water behind it is {:.4g} m deep (its conjugate "
                     "depth), and [domain] downstream is {:.4g} m: it will run {}",
                     conjugate, tail.depth, tail.depth > conjugate ? "to the inlet" : "out of the box"));
}

}  // namespace

double critical_depth(double q, double gravity) { return std::cbrt(q * q / gravity); }

double specific_energy(double depth, double speed, double gravity) { return depth + speed * speed / (2 * gravity); }

double conjugate_depth(double depth, double speed, double gravity) {
    return depth * (std::sqrt(1 + 8 * speed * speed / (gravity * depth)) - 1) / 2;
}

double through_gate(double opening, double energy, double gravity) {
    const double jet = contraction_of_gate * opening;
    return jet * std::sqrt(2 * gravity * std::max(0.0, energy - jet));
}

std::vector<Finding> channel_flow(const Scene& scene) {
    std::vector<Finding> findings;
    if (scene.motion.kind != Motion::Kind::stream || scene.hull || !(scene.water.gravity > 0) ||
        scene.domain.as_asked.min.z() >= 0 || !scene.effect_on("gravity"))
        return findings;
    const double floor = scene.domain.as_asked.min.z(), clear = scene.resolution.near_hull;
    const Coming coming{-floor, scene.motion.speed, scene.water.gravity};
    const std::optional<Tailwater> tail = tailwater(scene);
    bool is_free = true;
    for (const Obstacle& o : scene.obstacles) {
        if (!reaches_across(o, scene)) continue;
        const Box at = o.surface.bounds();
        is_free = false;
        if (at.max.z() < 0 && at.min.z() < floor + clear)
            judge_weir(o, at.max.z() - floor, coming, findings);
        else if (at.max.z() >= 0 && at.min.z() > floor + clear)
            judge_gate(o, at.min.z() - floor, coming, tail && !tail->is_slow, findings);
    }
    if (is_free && tail && tail->is_slow && !coming.is_slow()) judge_jump(*tail, coming, findings);
    return findings;
}

}  // namespace tw

#include "sph_solver/levels/level_loads.h"

#include <fmt/format.h>

#include "base/errors.h"
#include "sph_solver/bodies/cluster_loads.h"
#include "sph_solver/loops/force_on_dummies.h"

namespace tw {

void LevelLoads::gather(const Vec3& moment_reference) {
    const auto arm = [&](const Cluster& g) {
        const auto k = static_cast<std::size_t>(&g - system_.near.clusters.data());
        return Vec3(steps_->centre_of_cluster(k) - moment_reference);
    };
    const std::size_t n = system_.bodies.size();
    std::vector<PushSum> sums(3 * n);
    const std::span<PushSum> pressed(sums.data(), n), rubbed(sums.data() + n, n), of_bodies(sums.data() + 2 * n, n);
    add_cluster_loads(system_.near.clusters, system_.walls.cluster_loads(), arm, pressed);
    for (const auto& effect : system_.effects)
        if (!effect->wall_loads().empty()) add_cluster_loads(system_.near.clusters, effect->wall_loads(), arm, rubbed);
    if (system_.walls.press()) {
        const WallPushes pushed = push_particles();
        std::vector<WallPush> own;
        std::vector<std::int32_t> pencils;
        for (std::size_t k = 0; k < pushed.pushes.size(); ++k) {
            const auto by = static_cast<std::size_t>(pushed.by[k]);
            if (share_.owns(by)) own.push_back(pushed.pushes[k]), pencils.push_back(share_.pencil_of(by));
        }
        for (const WallPush& p : own) of_bodies[p.body].add(p.force, p.place - moment_reference);
        system_.walls.set_pushes(share_.of_all_ranks(own, pencils));
    }
    if (system_.ranks().many() && all_fixed(system_.bodies) && !in_stages_) {
        waiting_ = std::move(sums);
        return;
    }
    system_.ranks().add(std::span(sums));
    set_loads(sums, moment_reference);
}

void LevelLoads::settle(const Vec3& moment_reference) {
    if (!waiting_.empty()) set_loads(waiting_, moment_reference);
    waiting_.clear();
}

/// By bodies that press.
WallPushes LevelLoads::push_particles() {
    const MayBePressed may_be{system_.particles.wall_normal.data(), system_.particles.kind.data(), system_.setup.dp};
    const std::vector<std::int32_t> near = steps_->copy_pressed_to_host(may_be);
    WallPushes pushed = wall_pushes(system_.bodies, system_.particles, near, system_.setup.dp, system_.mass);
    steps_->push(pushed.by, pushed.accelerations);
    return pushed;
}

/// The force of the pressure that the particles do not carry.
void LevelLoads::add_archimedes(std::size_t b, const Vec3& moment_reference, Load& load) const {
    const Surroundings::Submerged& solid = system_.around.submerged[b];
    const Vec3 centroid = system_.bodies[b]->now(solid.centroid);
    if (centroid.z() + solid.radius > system_.around.at_rest->bottom)
        throw RunError(fmt::format(
            "{} came within {:.4g} m of still water at t = {:.6g} s, where the particles carry the whole "
            "pressure; what "
            "comes then is not solved with [effects] dynamic_pressure = \"on\": end the run before it, or "
            "set it to \"off\"",
            system_.bodies[b]->name(), system_.around.at_rest->surface - centroid.z() - solid.radius, system_.time));
    const Vec3 up(0, 0, system_.around.at_rest->weight * solid.volume);
    load.force += up;
    load.moment += (centroid - moment_reference).cross(up);
}

void LevelLoads::set_loads(std::span<const PushSum> sums, const Vec3& moment_reference) {
    const std::size_t n = system_.bodies.size();
    const auto pressed = sums.first(n), rubbed = sums.subspan(n, n), of_bodies = sums.last(n);
    // force on the bodies = minus what they exert on the water
    std::vector<Load> loads(n);
    for (std::size_t b = 0; b < n; ++b) {
        loads[b].friction = -system_.mass * rubbed[b].push.value();
        loads[b].force = of_bodies[b].push.value() - system_.mass * pressed[b].push.value() + loads[b].friction;
        PushSum by_walls = pressed[b];
        by_walls += rubbed[b];
        loads[b].moment = of_bodies[b].turn.value() - system_.mass * by_walls.turn.value();
        if (system_.around.at_rest) add_archimedes(b, moment_reference, loads[b]);
    }
    system_.walls.set_loads(std::move(loads));
}

std::vector<Vec3> LevelLoads::on_dummies(std::size_t body) {
    if (system_.walls.empty()) return {};
    const StepView step = steps_->step_view(system_.time);
    const StepView::DummiesOfBody& dummies = step.bodies[body];
    const auto lanes = static_cast<std::size_t>(system_.passes.lanes);
    V3<double>* const force =
        forces_on_dummies_.zeros(step.device, static_cast<std::size_t>(system_.walls.body_end()[body]) - dummies.first);
    step.each(lanes * dummies.clusters.size(), ForceOnDummies{.water = step.water,
                                                              .walls = step.dummies,
                                                              .unit = system_.fixed_point.size,
                                                              .own = step.n,
                                                              .first = dummies.first,
                                                              .lists = dummies.water,
                                                              .clusters = dummies.clusters.data(),
                                                              .lanes = lanes,
                                                              .force = force});
    // each by the rank whose pencil it stands in, nothing on the others
    std::vector<double> sums;
    for (const V3<double>& f : forces_on_dummies_.copy_to_host()) sums.insert(sums.end(), {f.x, f.y, f.z});
    system_.ranks().take_from_owners(std::span(sums));
    std::vector<Vec3> forces;
    for (std::size_t k = 0; k < sums.size(); k += 3) forces.emplace_back(sums[k], sums[k + 1], sums[k + 2]);
    return forces;
}

}  // namespace tw

#include "scene/water/water_at_start.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/disjoint_boxes.h"
#include "base/gap.h"
#include "scene/water/water_grid.h"

namespace tw {
namespace {

constexpr std::size_t most_named = 8;

std::string where(const Box& box, bool flat) {
    return flat ? fmt::format("x {:.4g} to {:.4g}, z {:.4g} to {:.4g} m", box.min.x(), box.max.x(), box.min.z(),
                              box.max.z())
                : fmt::format("x {:.4g} to {:.4g}, y {:.4g} to {:.4g}, z {:.4g} to {:.4g} m", box.min.x(), box.max.x(),
                              box.min.y(), box.max.y(), box.min.z(), box.max.z());
}

std::string state_of(const WaterGrid::Part& part) {
    if (!part.is_free)
        return fmt::format("no free surface; begins with no pressure at its top, z = {:.4g} m", part.level);
    if (part.at_rest()) return fmt::format("at rest, level z = {:.4g} m", part.level);
    const std::string begins = "; begins under the pressure of incompressible water at that moment";
    if (part.let_go) return "released where no wall holds it" + begins;
    return fmt::format(
        "surfaces from z = {:.4g} to {:.4g} m are connected: it runs until they are level, also into what "
        "a solid encloses, unless the effect air is on{}",
        part.lowest, part.level, begins);
}

/// Two blocks with less than half a particle between them.
void say_gaps(const Scene& scene, std::vector<std::string>& said) {
    const double dp = scene.resolution.near_hull;
    for (std::size_t i = 0; i < scene.water_blocks.size() && said.size() < most_named; ++i)
        for (std::size_t j = 0; j < i && said.size() < most_named; ++j) {
            const double gap = gap_of_boxes(scene.water_blocks[i], scene.water_blocks[j]);
            if (gap > 1e-3 * dp && gap < 0.5 * dp)
                said.push_back(
                    fmt::format("blocks {} and {} are {:.3g} m apart, less than half a particle of {:.4g} m: "
                                "the particles treat them as touching; let them share a face",
                                j + 1, i + 1, gap, dp));
        }
}

}  // namespace

std::vector<std::string> water_at_start(const Scene& scene) {
    std::vector<std::string> said;
    if (scene.water_blocks.empty() || !(scene.water.gravity > 0)) return said;
    const bool flat = scene.domain.dimensions == 2;
    const double dp = scene.resolution.near_hull;
    say_gaps(scene, said);
    std::vector<SurfaceQuery> solids;
    if (scene.hull) solids.emplace_back(scene.hull->surface);
    for (const Obstacle& o : scene.obstacles) solids.emplace_back(o.surface);
    for (const MovingBody& b : scene.bodies) solids.emplace_back(b.surface);
    const Domain& d = scene.domain;
    const auto holds = [](Side side) { return side == Side::slip_wall || side == Side::symmetry; };
    const WaterBounds bounds{
        d.dimensions,
        d.box,
        {{{holds(d.x_min), holds(d.x_max)}, {holds(d.y_min), holds(d.y_max)}, {holds(d.z_min), holds(d.z_max)}}},
        solids,
        0.5 * dp};
    std::vector<std::string> parts;
    std::size_t waters = 0;
    for (const std::vector<Box>& water : disjoint_groups(scene.water_blocks, d.dimensions, 0.5 * dp)) {
        for (const Box& box : water)
            for (int a = 0; a < 3; ++a)
                if ((a != 1 || !flat) && box.size()[a] < 0.5 * dp && said.size() < most_named)
                    said.push_back(fmt::format(
                        "the water at {} is thinner than half a particle of {:.4g} m: {}; use a finer near_hull",
                        where(box, flat), dp,
                        water.size() > 1 ? "its particles stand further apart instead" : "there are none of it"));
        const WaterGrid grid(water, bounds, dp, 1e5);
        for (const WaterGrid::Part& part : grid.parts()) {
            ++waters;
            if (parts.size() < most_named) parts.push_back(where(part.bounds, flat) + ": " + state_of(part));
        }
    }
    if (scene.water_blocks.size() == 1 && waters == 1 && parts.front().find("at rest") != std::string::npos)
        return said;
    if (waters > parts.size()) parts.push_back(fmt::format("and {} more", waters - parts.size()));
    said.insert(said.begin(), parts.begin(), parts.end());
    return said;
}

}  // namespace tw

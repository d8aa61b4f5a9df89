#pragma once
#include "foam_cases/plan_case.h"
#include "meshes/generate.h"
#include "meshes/section.h"
#include "scene/scene.h"

namespace tw {

/// The prismatic planing hull in a stream, half a model, spacing L/12 and four levels to the wet bottom.
inline Scene planing_scene() {
    Scene s;
    s.title = "planing";
    Hull hull;
    hull.surface = posed(make_hull("prismatic", {{"length", 4}, {"beam", 1}, {"deadrise", 0.349}}),
                         {.trim = 0.0873, .draft = 0.2});
    hull.half = true;
    hull.length = 4;
    hull.beam = 1;
    hull.draft = 0.2;
    s.hull = hull;
    s.motion = {Motion::Kind::stream, 8, 0};
    s.domain.box = {Vec3(-3, 0, -2), Vec3(5, 2, 1.5)};
    s.domain.x_min = Side::inlet;
    s.domain.x_max = Side::outlet;
    s.domain.y_min = Side::symmetry;
    s.resolution = {1.0 / 3, 1.0 / 24};
    s.refinement = {{"wake", {Vec3(-2.5, -1, -0.9), Vec3(4.5, 1.5, 0.7)}, 1},
                    {"wet bottom", {Vec3(-0.5, -1, -0.25), Vec3(2.1, 0.55, 0.1)}, 3}};
    s.sampling.interval = 0.05;
    s.run.duration = 1;
    return s;
}

/// A flat plate in a stream, 2-D: its section, one metre of span.
inline Scene flat_plate_scene() {
    Scene s = planing_scene();
    s.hull->surface = section_prism(posed(make_hull("plate", {}), {.trim = 0.5, .draft = 0.1}));
    s.hull->half = false;
    s.hull->section = true;
    s.hull->beam = 1;
    s.domain.dimensions = 2;
    s.domain.box = {Vec3(-4, -0.05, -1), Vec3(4, 0.05, 3)};
    s.domain.y_max = Side::symmetry;
    s.resolution = {0.1, 0.1};
    s.refinement.clear();
    return s;
}

/// A column of water in a flat tank, 2-D.
inline Scene dam_break_scene() {
    Scene s;
    s.title = "dam break";
    s.domain.box = {Vec3(0, 0, 0), Vec3(0.584, 0.01, 0.4)};
    s.domain.dimensions = 2;
    s.resolution = {0.0146, 0.0146};
    s.water_blocks = {{Vec3(0, 0, 0), Vec3(0.146, 0.01, 0.292)}};
    s.sampling.interval = 0.02;
    s.run.duration = 0.1;
    return s;
}

}  // namespace tw

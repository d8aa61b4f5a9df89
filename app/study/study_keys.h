#pragma once
#include <optional>
#include <utility>

#include "scene/scene.h"

namespace tw::app {

// The numbers of a run's changes to its scene, as study.json has them: those that may be missing, and those that are 1
// unless said otherwise.
inline constexpr std::pair<const char*, std::optional<double> SceneOverrides::*> given_in_study[] = {
    {"speed", &SceneOverrides::speed},
    {"spacing", &SceneOverrides::spacing},
    {"near_hull", &SceneOverrides::near_hull},
    {"duration", &SceneOverrides::duration},
    {"trim", &SceneOverrides::trim},
    {"wave_length", &SceneOverrides::wave_length},
    {"scale", &SceneOverrides::scale_resolution}};
inline constexpr std::pair<const char*, double SceneOverrides::*> factors_in_study[] = {
    {"sound_speed_factor", &SceneOverrides::sound_speed_factor},
    {"time_step_factor", &SceneOverrides::time_step_factor},
    {"courant_factor", &SceneOverrides::courant_factor},
    {"box_factor", &SceneOverrides::box_factor}};

}  // namespace tw::app

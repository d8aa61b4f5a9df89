#pragma once
// What a device does for effects: their loops and pair loops as kernels, a line each. Bodies and views stand beside the
// effects.

// clang-format off

// Pair loops over clusters and their neighbours: pair loop(NAME, VIEW).
#define TW_EFFECT_PAIR_LOOPS(pair_loop)                                                             \
    pair_loop(tw_velocity_at_walls, WaterVelocityData) pair_loop(tw_friction, ViscousForceData)     \
        pair_loop(tw_strain_rate, StrainRateData) pair_loop(tw_colour_gradient, ColourGradientData) \
            pair_loop(tw_curvature, CurvatureData)

// One index by one thread: task(NAME, TASK).
#define TW_EFFECT_TASKS(task)                                                                       \
    task(tw_mark_air, MarkAir) task(tw_note_air, NoteAir) task(tw_damp_sound, DampSound)            \
        task(tw_cut_off_tension, CutOffTension) task(tw_force_in_zones, ForceInZones)               \
            task(tw_force_to_wave, ForceTowardsWave) task(tw_force_to_sea, ForceTowardsSea)         \
                task(tw_feel_motion, FeelMotion)                                                    \
                task(tw_set_viscosity, SetViscosity) task(tw_copy_motion, CopyMotion)               \
                    task(tw_hold_at_walls, HoldAtWalls) task(tw_normal_of_surface, NormalOfSurface) \
                        task(tw_pull_at_surface, PullAtSurface)

// The same, and the largest of what they give: largest(NAME, TASK).
#define TW_EFFECT_LARGEST(largest) largest(tw_add_eddies, AddEddies) largest(tw_weigh_under_surface, WeighUnderSurface)

// Clusters by a condition, choose(NAME, CONDITION), and pair loops over those that it chose: pair loop(NAME, VIEW).
#define TW_EFFECT_CHOICES(choose) choose(tw_may_get_air, MayGetAir)
#define TW_EFFECT_PAIR_LOOPS_OF_CHOSEN(pair_loop) pair_loop(tw_near_air, NearAirData)

// What images have of an effect's own arrays (ghosts/laws.h).
#define TW_IMAGE_TASKS(task) \
    task(tw_see_scalars, SeeScalars) task(tw_see_vectors, SeeVectors) task(tw_see_held, SeeHeld)

// clang-format on

// Rows of the water, of how it is resolved and recorded, and of both methods.
#include <numbers>

#include "methods/methods.h"
#include "scene/keys/key_rows.h"

namespace tw {
namespace {

using Rows = std::vector<SceneKey>;
using Kind = SceneKey::Kind;
using Hashed = SceneKey::Hashed;

constexpr double fastest_sound = 1e5;  ///< [m/s]: a larger sound speed is refused as a mistake

/// The k-th probe: those of pressures, then those of heights.
Slot probes_filter() {
    return {Slot::In<double>([](Scene& scene, std::size_t k) -> double& {
                Sampling& s = scene.sampling;
                return k < s.pressure.size() ? s.pressure[k].filter : s.height[k - s.pressure.size()].filter;
            }),
            [](const Scene& scene) { return scene.sampling.pressure.size() + scene.sampling.height.size(); },
            [](Scene& scene) { scene.sampling.pressure.resize(1); }};
}
/// Of the k-th of one kind of them.
template <class Probe>
Slot slot_of_probes(std::vector<Probe> Sampling::*probes, double Probe::*value) {
    return {Slot::In<double>(
                [probes, value](Scene& scene, std::size_t k) -> double& { return (scene.sampling.*probes)[k].*value; }),
            [probes](const Scene& scene) { return (scene.sampling.*probes).size(); },
            [probes](Scene& scene) { (scene.sampling.*probes).resize(1); }};
}

}  // namespace

// The table is read by its rows.
// clang-format off

Rows water_keys() {
    return {
        {.name = "depth", .unit = "m", .range = positive, .hashed = Hashed::scene, .fallback = "deep",
         .meaning = "Depth of the water; the solved depth is smaller where the hull needs less."},
        {.name = "density", .unit = "kg/m3", .range = {1, 30000}, .hashed = Hashed::scene,
         .slot = slot(&Scene::water, &Water::density), .meaning = "Density of the water."},
        {.name = "viscosity", .unit = "m2/s", .range = {0, 1}, .hashed = Hashed::scene,
         .slot = slot(&Scene::water, &Water::kinematic_viscosity), .meaning = "Kinematic viscosity of the water."},
        {.name = "surface_tension", .unit = "N/m", .range = {0, 10}, .hashed = Hashed::scene,
         .slot = slot(&Scene::water, &Water::surface_tension), .meaning = "Surface tension between water and air."},
        {.name = "gravity", .unit = "m/s2", .range = {0, 1000, true}, .hashed = Hashed::scene,
         .slot = slot(&Scene::water, &Water::gravity), .meaning = "Gravitational acceleration, along -z.",
         .hint = "to leave gravity out write [effects] gravity = \"off\""},
        {.name = "air_density", .unit = "kg/m3", .range = {0, 100, true}, .hashed = Hashed::scene,
         .slot = slot(&Scene::water, &Water::air_density), .meaning = "Density of the air."},
        {.name = "air_viscosity", .unit = "m2/s", .range = {0, 1}, .hashed = Hashed::scene,
         .slot = slot(&Scene::water, &Water::air_kinematic_viscosity), .meaning = "Kinematic viscosity of the air."},
    };
}

Rows motion_keys() {
    return {
        {.name = "kind", .kind = Kind::choice, .choices = {"stream", "none"}, .hashed = Hashed::scene,
         .fallback = "stream with a hull, else none",
         .meaning = "A hull in a uniform stream, or still water (a tank)."},
        {.name = "speed", .unit = "m/s", .range = {0, 1000, true}, .hashed = Hashed::scene,
         .slot = slot(&Scene::motion, &Motion::speed), .fallback = "required in a stream",
         .meaning = "Speed of the stream, along +x.", .hint = "for still water write kind = \"none\""},
        {.name = "ramp", .unit = "s", .range = not_negative, .hashed = Hashed::run, .fallback = "0.3 L/U",
         .meaning = "Time over which the particle method starts the stream."},
    };
}

Rows wave_keys() {
    return {
        {.name = "height", .unit = "m", .range = positive, .hashed = Hashed::scene,
         .slot = slot(&Scene::wave_asked, &WaveOptions::height), .fallback = "required of a regular wave and of two waves",
         .meaning = "Height of the wave from trough to crest.", .later = true},
        {.name = "length", .unit = "m", .range = positive, .hashed = Hashed::scene,
         .slot = slot(&Scene::wave_asked, &WaveOptions::length), .fallback = "from the period",
         .meaning = "Distance from crest to crest; length or period is given.", .later = true},
        {.name = "period", .unit = "s", .range = positive, .hashed = Hashed::scene,
         .slot = slot(&Scene::wave_asked, &WaveOptions::period), .fallback = "from the length",
         .meaning = "Time between two crests at a place of the tank; in a stream that in its water, between two crests "
                    "that meet what drifts with it.", .later = true},
        {.name = "direction", .unit = "rad", .range = {-std::numbers::pi, std::numbers::pi}, .hashed = Hashed::scene,
         .slot = slot(&Scene::wave_asked, &WaveOptions::direction), .fallback = "0 deg",
         .meaning = "Where the wave runs: 0 towards +x, \"90 deg\" towards +y, \"180 deg\" towards -x; in a stream 0 are head waves and \"180 deg\" following ones. Others, oblique ones, need a stream in three dimensions and a whole hull.", .later = true},
        {.name = "theory", .kind = Kind::choice, .choices = {"auto", "linear", "stream_function"},
         .hashed = Hashed::scene, .slot = slot(&Scene::wave_asked, &WaveOptions::theory),
         .meaning = "Velocities and surface of the wave: linear where that changes neither crest nor speed by more than "
                    "0.5 %, else Fenton's stream function.", .later = true},
        {.name = "spectrum", .kind = Kind::choice,
         .choices = {"regular", "jonswap", "pierson-moskowitz", "bichromatic", "focused"}, .hashed = Hashed::scene,
         .slot = slot(&Scene::wave_asked, &WaveOptions::spectrum),
         .meaning = "A regular wave, or a sum of linear ones: of a spectrum with phases at random, two waves, or a group "
                    "whose components have their crests at one place and time (NewWave).", .later = true},
        {.name = "significant_height", .unit = "m", .range = positive, .hashed = Hashed::scene,
         .slot = slot(&Scene::wave_asked, &WaveOptions::significant_height), .fallback = "required with a spectrum",
         .meaning = "Significant height of a spectrum, 4 sqrt(m0).", .later = true},
        {.name = "peak_period", .unit = "s", .range = positive, .hashed = Hashed::scene,
         .slot = slot(&Scene::wave_asked, &WaveOptions::peak_period), .fallback = "required with a spectrum and a focused wave",
         .meaning = "Period at the peak of the spectrum; in a stream that in its water.", .later = true},
        {.name = "peakedness", .range = {1, 10}, .hashed = Hashed::scene,
         .slot = slot(&Scene::wave_asked, &WaveOptions::peakedness),
         .meaning = "JONSWAP's gamma, of a focused wave too; 1 is the spectrum of Pierson and Moskowitz.", .later = true},
        {.name = "components", .kind = Kind::whole, .range = {8, WaveComponents::most}, .hashed = Hashed::scene,
         .slot = slot(&Scene::wave_asked, &WaveOptions::components),
         .meaning = "Linear waves that make up a spectrum or a focused wave; the sea repeats itself after half as many peak periods.", .later = true},
        {.name = "seed", .kind = Kind::whole, .range = {0, 2e9}, .hashed = Hashed::scene,
         .slot = slot(&Scene::wave_asked, &WaveOptions::seed),
         .meaning = "Of the phases at random: the same number gives the same sea, in both methods and on every machine.", .later = true},
        {.name = "empty_twin", .kind = Kind::choice, .choices = {"auto", "on", "off"},
         .slot = slot(&Scene::wave_asked, &WaveOptions::empty_twin), .fallback = "auto: on in two dimensions with a free body",
         .meaning = "Of a regular wave with a free body: each size is also run without the bodies, and responses are given over the wave that is measured there. On request of a tank without bodies too: without its obstacles, and the force of the wave on a single one is given over the wave there.", .later = true},
        {.name = "calm_twin", .kind = Kind::choice, .choices = {"auto", "on", "off"},
         .slot = slot(&Scene::wave_asked, &WaveOptions::calm_twin), .fallback = "auto: on in two dimensions",
         .meaning = "Of a regular wave before a hull in a stream: each size is also run without the wave, and what drag, trim and rise are more in waves is given as added by them.", .later = true},
        {.name = "second_height", .unit = "m", .range = positive, .hashed = Hashed::scene,
         .slot = slot(&Scene::wave_asked, &WaveOptions::second_height), .fallback = "required with two waves",
         .meaning = "Height of the second of two waves (bichromatic); `height` and `period` are the first one's.", .later = true},
        {.name = "second_period", .unit = "s", .range = positive, .hashed = Hashed::scene,
         .slot = slot(&Scene::wave_asked, &WaveOptions::second_period), .fallback = "required with two waves",
         .meaning = "Period of the second of two waves.", .later = true},
        {.name = "crest", .unit = "m", .range = positive, .hashed = Hashed::scene,
         .slot = slot(&Scene::wave_asked, &WaveOptions::crest), .fallback = "required with a focused wave",
         .meaning = "Crest of a focused wave by linear theory, the sum of its amplitudes.", .later = true},
        {.name = "focus_place", .unit = "m", .hashed = Hashed::scene,
         .slot = slot(&Scene::wave_asked, &WaveOptions::focus_place), .fallback = "the middle between the zones, or of the box where the waves enter with a stream",
         .meaning = "Where a focused wave has its crest, along x.", .later = true},
        {.name = "focus_time", .unit = "s", .range = not_negative, .hashed = Hashed::scene,
         .slot = slot(&Scene::wave_asked, &WaveOptions::focus_time),
         .fallback = "4 peak periods; with solids in the tank also the way of the slowest waves through the zone that makes them and to the focus; in a stream that way, or that from the inlet, and the start",
         .meaning = "When it has it.", .later = true},
    };
}

Rows resolution_keys() {
    return {
        {.name = "near_hull", .unit = "m", .range = positive, .hashed = Hashed::scene,
         .fallback = "the smaller of B/20 and D/4",
         .meaning = "Particle spacing, and size of the mesh cells at the wetted hull: the finest size."},
        {.name = "spacing", .unit = "m", .range = positive, .hashed = Hashed::scene,
         .fallback = "near_hull 2^n, at most L/12, n at most 4",
         .meaning = "Size of the largest cells, and of the particles farthest from solids as far as there is room for them; rounded to near_hull times a power of two."},
    };
}

Rows domain_keys() {
    const auto distance = [](const char* name, const char* fallback, const char* meaning) {
        return SceneKey{.name = name,
                        .unit = "m",
                        .range = positive,
                        .hashed = Hashed::scene,
                        .fallback = fallback,
                        .meaning = meaning};
    };
    const auto extent = [](const char* name, const char* meaning) {
        return SceneKey{.name = name,
                        .kind = Kind::pair,
                        .unit = "m",
                        .hashed = Hashed::scene,
                        .fallback = "from the distances",
                        .meaning = meaning};
    };
    return {
        distance("ahead", "0.6 L ahead of the keel's entry, at least 0.15 L; from Froude number 1 on, with particles of "
                 "several sizes, 0.8 L more", "Distance from the bow to the inlet."),
        distance("behind", "L", "Distance from the stern to the outlet."),
        distance("side", "2 B; below Froude number 1 at least L/2; above it, with particles of several sizes, 1.5 times as far as where by the formula of the warning they change the lift by 0.5 %", "Distance from y = 0 to the sides."),
        distance("below",
                 "the larger of 1.6 B and 4 D (of a submerged body D and three of its heights); below Froude number 1 "
                 "also half a wavelength, at most L/2; above it, with particles of several sizes, 1.5 times as deep as where by the formula of the warning the floor changes the lift by 0.5 %",
                 "Depth of the floor below still water."),
        distance("above", "the largest of L/2, L/4 above the deck and U^2/(8 g) (at most L)",
                 "Height of the top above still water."),
        extent("x", "Extent along the stream, instead of ahead and behind."),
        extent("y", "Extent across the stream, instead of side."),
        extent("z", "Extent in height, instead of below and above."),
        {.name = "dimensions", .kind = Kind::whole, .range = {2, 3}, .hashed = Hashed::scene, .fallback = "3",
         .meaning = "3, or 2 for the x-z plane: of a hull its section with y = 0; forces are then per metre of span."},
        {.name = "sides", .kind = Kind::choice, .choices = {"open", "walls"}, .hashed = Hashed::scene,
         .slot = slot(&Scene::zones, &ZoneOptions::sides),
         .meaning = "Beside a hull in a stream: open water, where waves are absorbed and the influence of the box is part "
                    "of the intervals, or walls, as of a towing tank: the values are then those of a channel of this size.",
         .later = true},
    };
}

Rows run_keys() {
    return {
        {.name = "duration", .unit = "s", .range = positive, .slot = slot(&Scene::run, &Run::duration),
         .fallback = "ramp + 3 L/U, below Froude number 1 at least ramp + 32 pi U/g, of a free hull five heaves more (check tells); twice that where stop is \"settled\"; 10 sqrt(H/g) in a tank "
                     "of water height H",
         .meaning = "Simulated time; a longer run of the same scene has the same hash. With stop = \"settled\" the most that a run may take; without it (or as \"auto\") a hull that is held in a stream stops when its loads have settled."},
        {.name = "stop", .kind = Kind::choice, .choices = {"auto", "settled", "duration"}, .slot = slot(&Scene::run, &Run::stop),
         .meaning = "What ends a run of a hull held in a stream: its duration, or, before that, that drag, lift and trim "
                    "moment have settled. \"auto\": settled where no duration is written, else the duration."},
        {.name = "methods", .kind = Kind::choices, .choices = method_names(),
         .slot = slot(&Scene::run, &Run::methods),
         .meaning = "Which methods are run: particles (sph), OpenFOAM (fvm) or both."},
        {.name = "threads", .kind = Kind::whole, .range = {0, 4096}, .slot = slot(&Scene::run, &Run::threads),
         .meaning = "Threads of the particle method and ranks of the mesh method; 0: all cores."},
        {.name = "ranks", .kind = Kind::whole, .range = {1, 65535}, .slot = slot(&Scene::run, &Run::ranks),
         .meaning = "Processes (MPI) that share the particles of `twinwake run`, each with its threads or a GPU of its own; run "
                    "--ranks goes before it. Runs of other studies have one each. The results have the same bits for any number."},
        {.name = "device", .kind = Kind::choice, .choices = {"cpu", "gpu", "auto"}, .slot = slot(&Scene::run, &Run::device),
         .meaning = "What makes the particles' steps: this processor, a GPU, or a GPU where there is one. Both give the "
                    "same but for last digits."},
        {.name = "checkpoint", .unit = "s", .range = positive, .slot = slot(&Scene::run, &Run::checkpoint),
         .fallback = "a twentieth of the duration",
         .meaning = "Simulated time between saved states of the particle method."},
    };
}

Rows sampling_keys() {
    return {
        {.name = "interval", .unit = "s", .range = positive, .hashed = Hashed::scene,
         .slot = slot(&Scene::sampling, &Sampling::interval), .fallback = "L/U / 25; in a tank sqrt(H/g) / 25",
         .meaning = "Time between samples (frames of the water raster, energies, height probes); pressure probes "
                    "are sampled more often."},
        {.name = "mean_from", .unit = "s", .range = positive, .hashed = Hashed::scene,
         .slot = slot(&Scene::sampling, &Sampling::mean_from),
         .fallback = "ramp + L/U or 8 pi U/g, the longer, and two heaves of a free hull; 5 sqrt(H/g) for a hull in still water; in a tank with a wave three of its periods, and with solids in it, or in a stream, also the wave's way to the other zone; none in other tanks without a hull",
         .meaning = "Settled means do not begin before this time; in a tank without a hull nor do the largest heights of "
                    "splash."},
        {.name = "snapshots", .unit = "s", .range = not_negative,
         .slot = slot(&Scene::sampling, &Sampling::snapshot_interval),
         .meaning = "Time between ParaView files; 0: the last moment alone."},
        {.name = "raster_spacing", .unit = "m", .range = positive, .hashed = Hashed::scene,
         .fallback = "2 near_hull; near_hull in two dimensions",
         .meaning = "Edge of the voxels in which both methods count their water, for splash heights."},
        {.name = "cuts_x", .kind = Kind::list, .unit = "m", .hashed = Hashed::scene,
         .slot = slot(&Scene::sampling, &Sampling::cuts_x),
         .fallback = "where no cut is written: half a hull's length behind it",
         .meaning = "Planes x = const of surface profiles."},
        {.name = "cuts_y", .kind = Kind::list, .unit = "m", .hashed = Hashed::scene,
         .slot = slot(&Scene::sampling, &Sampling::cuts_y),
         .fallback = "where no cut is written: 3/4 of a hull's beam; the middle of a tank",
         .meaning = "Planes y = const of surface profiles."},
    };
}

Rows probe_keys() {
    return {
        {.name = "name", .kind = Kind::name, .hashed = Hashed::scene, .fallback = "P1, P2, ... or H1, H2, ...",
         .meaning = "Name of the probe's column in the record."},
        {.name = "pressure", .kind = Kind::place3, .unit = "m", .hashed = Hashed::scene, .fallback = "none",
         .meaning = "Place at which the pressure is recorded."},
        {.name = "height", .kind = Kind::place2, .unit = "m", .hashed = Hashed::scene, .fallback = "none",
         .meaning = "Place at which the height of the water is recorded: of the highest water that stands on the floor or a "
                    "solid there; where all is dry, of what it would stand on; nothing where a solid lies on the water, "
                    "as under a floating body."},
        {.name = "filter", .unit = "s", .range = positive, .hashed = Hashed::scene, .slot = probes_filter(),
         .fallback = "5 ms",
         .meaning = "Time over which its peak is a mean, as the measurement it is compared with was filtered: 0.44 over the cut-off frequency of a low pass.", .later = true},
        {.name = "slam", .unit = "Pa", .range = positive, .hashed = Hashed::scene,
         .slot = slot_of_probes(&Sampling::pressure, &PressureProbe::slam), .fallback = "none are counted",
         .meaning = "Of a pressure in waves: in how many periods its peak is above this, each a slam.", .later = true},
        {.name = "deck", .unit = "m", .hashed = Hashed::scene,
         .slot = slot_of_probes(&Sampling::height, &HeightProbe::deck), .fallback = "none are counted",
         .meaning = "Of a height in waves: in how many periods the water is above this level, as green water on a deck.", .later = true},
    };
}

Rows volume_keys() {
    return {
        {.name = "name", .kind = Kind::name, .hashed = Hashed::scene, .fallback = "V1, V2, ...",
         .meaning = "Name of the box's column in the record."},
        {.name = "min", .kind = Kind::place3, .unit = "m", .hashed = Hashed::scene, .fallback = "required",
         .meaning = "Low corner; in two dimensions y is not used. A face of the box belongs into the solid or beyond the wall on which water lies, not onto it."},
        {.name = "max", .kind = Kind::place3, .unit = "m", .hashed = Hashed::scene, .fallback = "required",
         .meaning = "High corner; the box may reach beyond the domain. Of a half model it counts what is solved."},
    };
}

Rows measured_keys() {
    return {
        {.name = "quantity", .kind = Kind::text, .fallback = "required",
         .meaning = "Name of the quantity in report.json and quantities.csv: lift, total_drag, heave_response:hull, ..."},
        {.name = "value", .kind = Kind::text, .fallback = "required",
         .meaning = "What was measured, with its unit in quotes: \"71.25 N\"; of a half model that of the whole hull."},
        {.name = "uncertainty", .kind = Kind::text, .fallback = "not known",
         .meaning = "Half width of its 95 % interval, in the same kind of unit or in per cent: \"3 N\", \"4 %\"."},
        {.name = "source", .kind = Kind::text, .fallback = "required", .meaning = "Who measured it, where it was published."},
        {.name = "speed", .unit = "m/s", .range = positive, .fallback = "the scene's",
         .meaning = "Of the stream in which it was measured: it counts at this speed alone, within 0.5 %. Without it the value is that of the scene as it is written, and not of another --speed."},
        {.name = "wave_length", .unit = "m", .range = positive, .fallback = "the scene's",
         .meaning = "Of the regular wave in which it was measured, in the same way: with it one scene can have the values of many waves, for sweep --wave-lengths."},
    };
}

Rows water_block_keys() {
    return {
        {.name = "min", .kind = Kind::place3, .unit = "m", .hashed = Hashed::scene, .fallback = "required",
         .meaning = "Low corner."},
        {.name = "max", .kind = Kind::place3, .unit = "m", .hashed = Hashed::scene, .fallback = "required",
         .meaning = "High corner."},
    };
}

Rows refine_keys() {
    return {
        {.name = "name", .kind = Kind::name, .fallback = "refine1, refine2, ...", .meaning = "Name in messages and meshes."},
        {.name = "around", .kind = Kind::choice, .choices = {"box", "wake", "free_surface", "spray_root"},
         .hashed = Hashed::scene, .fallback = "\"box\"",
         .meaning = "What is finer: a box; the wake behind the middle of the hull, half as wide again as it and down to "
                    "its draft; the still water's surface; or where jets leave the hull's bottom, between still water "
                    "and the height to which it rises on a wedge."},
        {.name = "min", .kind = Kind::place3, .unit = "m", .hashed = Hashed::scene, .fallback = "required of a box",
         .meaning = "Low corner of a box."},
        {.name = "max", .kind = Kind::place3, .unit = "m", .hashed = Hashed::scene, .fallback = "required of a box",
         .meaning = "High corner of a box."},
        {.name = "width", .unit = "m", .range = positive, .hashed = Hashed::scene, .fallback = "eight of its spacings",
         .meaning = "How far it reaches beyond what it is around; not of a box."},
        {.name = "length", .unit = "m", .range = positive, .hashed = Hashed::scene, .fallback = "to the outlet",
         .meaning = "Of a wake, behind the hull."},
        {.name = "spacing", .unit = "m", .range = positive, .hashed = Hashed::scene, .fallback = "near_hull",
         .meaning = "Largest particles and cells there: near_hull, the next smaller of its doubles, or down to an "
                    "eighth of it."},
    };
}

Rows sph_keys() {
    return {
        {.name = "h_over_dp", .range = {1.1, 3}, .hashed = Hashed::run,
         .slot = slot(&Scene::sph, &SphOptions::h_over_dp),
         .meaning = "Smoothing length over particle spacing; unless given 2 with surface tension and with a wave."},
        {.name = "c0", .unit = "m/s", .range = {0, fastest_sound, true}, .hashed = Hashed::run,
         .slot = slot(&Scene::sph, &SphOptions::c0),
         .fallback = "10 times the larger of U and sqrt(2 g H), of a planing hull over no bed with its draft for H, and of sqrt(2 sigma/(rho h)) with surface tension; with "
                     "dynamic pressure H is the layer under the surface; 40 times where water strikes an elastic plate",
         .meaning = "Numerical sound speed; the density error grows with (speed/c0)^2, the run time with c0."},
        {.name = "delta", .range = {0, 1}, .hashed = Hashed::run, .slot = slot(&Scene::sph, &SphOptions::delta),
         .meaning = "Coefficient of the density diffusion."},
        {.name = "alpha", .range = {0, 1}, .hashed = Hashed::run, .slot = slot(&Scene::sph, &SphOptions::alpha),
         .meaning = "Coefficient of the artificial viscosity; unless given 0.1 with surface tension, 0 with dynamic pressure and 0.001 with a wave."},
        {.name = "scheme", .kind = Kind::choice,
         .choices = {"symplectic_euler", "kick_drift_kick", "predictor_corrector", "rk4_frozen_diffusion"},
         .hashed = Hashed::run, .slot = slot(&Scene::sph, &SphOptions::scheme), .meaning = "Time stepping scheme."},
        {.name = "cfl", .range = {0, 1, true}, .hashed = Hashed::run, .slot = slot(&Scene::sph, &SphOptions::cfl),
         .meaning = "Acoustic Courant number: the time step is cfl h / (c0 + speed)."},
        {.name = "equation_of_state", .kind = Kind::choice, .choices = {"linear", "tait", "mie_grueneisen"},
         .hashed = Hashed::run, .slot = slot(&Scene::sph, &SphOptions::equation_of_state),
         .meaning = "Pressure as a function of density."},
        {.name = "gamma", .range = {1, 20}, .hashed = Hashed::run, .slot = slot(&Scene::sph, &SphOptions::gamma),
         .meaning = "Exponent of the Tait equation of state."},
        {.name = "levels", .kind = Kind::whole, .range = {1, most_levels}, .hashed = Hashed::run,
         .slot = slot(&Scene::sph, &SphOptions::levels),
         .fallback = "up to spacing, where that is written, and round a hull held in a stream from Froude number 1 on; else 1",
         .meaning = "Sizes of particles: near_hull round hull, obstacles and moving bodies, twice that farther away, and so on.",
         .later = true},
        {.name = "zone", .range = {8, 200}, .hashed = Hashed::run, .slot = slot(&Scene::sph, &SphOptions::zone),
         .meaning = "With several levels: how far the finest particles reach from the hull, and from the bounding boxes of obstacles and bodies, in their spacings; at a --scale from 0.71 to 2 as many metres as at 1.",
         .later = true},
        {.name = "zones", .kind = Kind::choice, .choices = {"coarse", "fine"}, .hashed = Hashed::run,
         .slot = slot(&Scene::sph, &SphOptions::zones),
         .meaning = "Particles in the forcing zones that lie outside the box of a stream: as large as those in the box, or twice as large.",
         .later = true},
        {.name = "wake", .kind = Kind::whole, .range = {0, 32}, .hashed = Hashed::run,
         .slot = slot(&Scene::sph, &SphOptions::wake),
         .fallback = "2 where sizes follow from spacing or the hull's speed; 0 where levels are written",
         .meaning = "With several levels and a hull in a stream: largest particles in its wake, over near_hull (1, 2, 4, ...; others are rounded down to these), where `[[refine]] around = \"wake\"` would have them; 0: none of its own.",
         .later = true},
        {.name = "touch_support", .range = {0.5, 0.999}, .hashed = Hashed::run,
         .slot = slot(&Scene::sph, &SphOptions::touch_support),
         .meaning = "Fullness of the kernel's half towards a wall from which on the approaching wall compresses the water."},
        {.name = "gate_point", .kind = Kind::list, .unit = "m", .hashed = Hashed::run,
         .slot = slot(&Scene::sph, &SphOptions::gate_point),
         .meaning = "With gate_normal: a plane beyond which detached water is taken out of the run at every frame, as droplets for `twinwake spray`. Three dimensions.",
         .later = true},
        {.name = "gate_normal", .kind = Kind::list, .hashed = Hashed::run,
         .slot = slot(&Scene::sph, &SphOptions::gate_normal), .meaning = "Direction from the plane to what lies beyond it.", .later = true},
        {.name = "gate_link", .range = {1, 10}, .hashed = Hashed::run,
         .slot = slot(&Scene::sph, &SphOptions::gate_link),
         .meaning = "Distance up to which particles count as connected at the spray gate, in spacings.", .later = true},
    };
}

Rows fvm_keys() {
    return {
        {.name = "max_courant", .range = {0, 20, true}, .hashed = Hashed::run,
         .slot = slot(&Scene::fvm, &FvmOptions::max_courant), .fallback = "4 in a stream, 0.15 in waves (up to 0.5 where they enter with the stream; four times as much with a "
                     "hull or bodies in two dimensions, beside which cells are a quarter as large), else 1",
         .meaning = "Largest Courant number of the flow."},
        {.name = "max_alpha_courant", .range = {0, 20, true}, .hashed = Hashed::run,
         .slot = slot(&Scene::fvm, &FvmOptions::max_alpha_courant),
         .fallback = "as max_courant (2 in a stream with isoadvector), 0.5 with a body that moves",
         .meaning = "Largest Courant number at the water surface."},
        {.name = "interface_compression", .range = {0, 4}, .hashed = Hashed::run,
         .slot = slot(&Scene::fvm, &FvmOptions::interface_compression),
         .meaning = "cAlpha, which keeps the water surface sharp."},
        {.name = "interface", .kind = Kind::choice, .choices = {"mules", "isoadvector"}, .hashed = Hashed::run,
         .slot = slot(&Scene::fvm, &FvmOptions::interface),
         .meaning = "How the water surface is captured: by interFoam's limited fluxes, or geometrically by interIsoFoam, which is sharper and takes several times as long.",
         .later = true},
        {.name = "correctors", .kind = Kind::whole, .range = {1, 10}, .hashed = Hashed::run,
         .slot = slot(&Scene::fvm, &FvmOptions::correctors), .fallback = "2 for a hull held in a stream, else 3",
         .meaning = "Pressure correctors in each time step."},
        {.name = "body_mesh", .kind = Kind::choice, .choices = {"auto", "morphing", "whole"}, .hashed = Hashed::run,
         .slot = slot(&Scene::fvm, &FvmOptions::body_mesh),
         .meaning = "How the mesh follows a body that moves: morphed between body and walls, or moving as a whole.",
         .later = true},
        {.name = "openfoam", .kind = Kind::text, .slot = slot(&Scene::fvm, &FvmOptions::openfoam),
         .fallback = "found", .meaning = "Folder of an OpenFOAM installation."},
    };
}
// clang-format on

}  // namespace tw

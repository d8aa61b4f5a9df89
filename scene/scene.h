#pragma once
#include <array>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/vec3.h"
#include "meshes/health.h"
#include "meshes/mass_properties.h"
#include "meshes/surface.h"
#include "methods/methods.h"
#include "motion/floating_attitude.h"
#include "motion/moving_frame.h"
#include "motion/rigid_body.h"
#include "record/effect_choice.h"
#include "record/measured_value.h"
#include "record/raster_spec.h"
#include "scene/elastic/elastic_tyre.h"
#include "scene/sph_options.h"
#include "waves/regular_wave.h"
#include "waves/sea.h"

namespace tw {

// The checked description both methods are set up from. Everything is SI, angles in radians; every default has been
// filled in. Axes: x to the stern (the stream's direction), z up, still water at z = 0.

struct Water {
    double density = 1000;                    ///< [kg/m3]
    double kinematic_viscosity = 1e-6;        ///< [m2/s]
    double surface_tension = 0.072;           ///< [N/m]
    double gravity = 9.81;                    ///< [m/s2], along -z
    double depth = 0;                         ///< [m], of the solved water (domain floor at z = -depth)
    double air_density = 1.2;                 ///< [kg/m3]
    double air_kinematic_viscosity = 1.5e-5;  ///< [m2/s]
    double atmospheric_pressure = 101325, vapour_pressure = 2340;  ///< [Pa], for cavitation
};

/// What a hull in a stream needs to rise and trim freely in heave and pitch; its surge is held, as by the carriage of a
/// towing tank.
struct FreeHull {
    RigidBodySetup motion;                    ///< of the whole hull
    Vec3 transom_keel = Vec3::Zero();         ///< lowest point of the transom as the hull stands at the start [m]
    std::optional<FloatingAttitude> at_rest;  ///< none: it does not float
};

struct Hull {
    std::string source;  ///< file name or generator name, as the user wrote it
    Surface surface;     ///< posed, in world coordinates [m]
    std::string hash;    ///< surface_hash(surface)
    /// Two dimensions: the surface is the section with the plane y = 0, drawn out to a span of one metre. Volumes and
    /// areas are then per metre of span, and so is everything that a run reports.
    bool section = false;
    bool half = false;                     ///< symmetric about y = 0: one half is solved, results are for the whole
    double trim = 0, heel = 0, draft = 0;  ///< [rad], [rad], [m]
    double length = 0, beam = 0;  ///< of the posed bounding box [m]; of a section the beam is its metre of span
    MassProperties mass;
    Hydrostatics still;            ///< of the part below z = 0
    std::optional<FreeHull> free;  ///< none: held as it stands
    std::vector<Finding> findings;
    std::vector<std::string> repairs;
};

struct Motion {
    enum class Kind {
        none,
        stream
    } kind = Kind::none;  ///< none: still water (tank); stream: a hull, held or free, in a uniform stream
    double speed = 0;     ///< [m/s], along +x
    double ramp = 0;      ///< start-up ramp of the stream [s] (SPH); 0: impulsive
};

/// The kind of each side of the domain. Both methods use the same list.
enum class Side { slip_wall, symmetry, inlet, outlet, atmosphere };
struct Domain {
    Box box;  ///< z from the floor to the top of the air (particles that fly out through it are gone; with air a lid is
              ///< there)
    /// The same before its faces were moved to multiples of the sizes: what does not depend on the resolution.
    Box as_asked;
    /// `box` without the forcing zones that lie outside it (forcing_zones.h).
    Box undamped;
    int dimensions = 3;  ///< 2: the x-z plane, one particle / cell thick in y
    /// The floor only ends the box, as the sides of a stream do; false: it is the bed, at the depth of the water.
    bool floor_ends_the_box = false;
    Side x_min = Side::slip_wall, x_max = Side::slip_wall, y_min = Side::slip_wall, y_max = Side::slip_wall,
         z_min = Side::slip_wall, z_max = Side::atmosphere;
};

/// Where forcing zones lie, and to what they draw (forcing_zones.h).
struct ZoneOptions {
    std::string sides = "open";     ///< beside a hull in a stream: open, walls (box_walls.h)
    std::string absorbing = "all";  ///< walls of a tank: all, x, y, x_min, ...
    double wave_length = 0;         ///< that those of a tank absorb [m]; 0: of its wave maker
    double downstream = 0;          ///< depth of the water where a stream leaves [m]; 0: as it comes (tailwater.h)
};

/// [wave] as written: a wave in a tank, regular or a sum of linear ones (scene/box/tank_wave.h).
struct WaveOptions {
    double height = 0;              ///< [m]; 0: there is no regular wave
    double length = 0, period = 0;  ///< [m], [s]; one of the two, the other 0
    double direction = 0;           ///< 0: towards +x, pi: towards -x [rad]
    std::string theory = "auto";    ///< auto, linear, stream_function
    /// regular, jonswap, pierson-moskowitz, bichromatic, focused
    std::string spectrum = "regular";
    double significant_height = 0, peak_period = 0;  ///< of a spectrum [m], [s]
    double peakedness = 3.3;                         ///< JONSWAP's gamma [-]
    int components = 60;                             ///< of a spectrum
    int seed = 1;                                    ///< of its phases
    double second_height = 0, second_period = 0;     ///< of the second of two waves [m], [s]
    double crest = 0;                                ///< of a focused wave to first order [m]
    double focus_place = 0, focus_time = 0;          ///< of it [m], [s]; as the scene is checked, filled in
    std::string empty_twin = "auto", calm_twin = "auto";  ///< auto, on, off: see wants_wave_twin
};

struct Resolution {
    double spacing = 0;    ///< far away: largest cell [m]
    double near_hull = 0;  ///< particle spacing dp, and cell size at the wetted hull [m]
    /// Both sizes were multiplied by this. Levels of refinement follow from the sizes without it, so that all scales of
    /// one scene are one family of similar meshes.
    double scale = 1;  ///< [-]
    /// Particles far away are to have `spacing` too. What there is no room for, which depends on the sizes, is left
    /// out; the box, which is the same for a family, follows from this alone.
    bool of_particles = false;
};

/// A place that the scene wants finer than what lies round it, in both methods ([[refine]]).
struct RefinedPlace {
    std::string name;
    enum class Around { box, wake, free_surface, spray_root } around = Around::box;
    std::optional<double> width, length;  ///< as written [m]
    std::vector<Box> boxes;               ///< that hold it: one, or a chain of overlapping ones
    /// Of near_hull: size = near_hull 2^halvings_short, the same at all scales; negative: finer than the hull.
    int halvings_short = 0;
};

/// Boxes of successively finer resolution, coarsest first; the FVM mesh refines in them.
struct RefinementBox {
    std::string name;
    Box box;
    int level = 0;  ///< cell size = spacing / 2^level
};

/// A closed solid beside the hull (a tank's obstacle), fixed.
struct Obstacle {
    std::string name;
    Surface surface;
};

/// A closed solid that moves, freely or as prescribed. In two dimensions its section, drawn out to a metre of span, and
/// masses and inertias are per metre. At the start it displaces water as a hull does.
struct MovingBody {
    std::string name;
    std::string source;     ///< file name or shape, as the user wrote it
    Surface surface;        ///< as it stands at the start [m]
    RigidBodySetup motion;  ///< a prescribed body without a mass has zeros there, but for the centre
    std::vector<Finding> findings;
    double filter = 0;  ///< the largest force is a mean over this time [s]; 0: 5 ms
    /// Of a free rigid body with floor and sides of a tank: Coulomb's coefficient [-].
    double friction = default_friction;              ///< [-]
    static constexpr double default_friction = 0.5;  ///< [-]
    /// Of an elastic body, whose surface is that which the water sees and whose motion that of its rigid counterpart.
    std::optional<ElasticPart> elastic = {};

    /// Null where it is no plate, or no tyre.
    const ElasticPlate* plate() const { return elastic ? std::get_if<ElasticPlate>(&*elastic) : nullptr; }
    const ElasticTyre* tyre() const { return elastic ? std::get_if<ElasticTyre>(&*elastic) : nullptr; }

    /// An upper bound of the speed of its surface until it touches still water, z = 0, at gravity `g` [m/s].
    double fastest(double g) const;
    bool free_and_rigid() const { return !motion.law && !elastic; }
};

struct PressureProbe {
    std::string name;
    Vec3 place;         ///< [m]
    double filter = 0;  ///< its peak is a mean over this time [s]; 0: 5 ms
    double slam = 0;    ///< peaks above it are events in waves [Pa]; 0: none are counted
};
struct HeightProbe {
    std::string name;
    double x = 0, y = 0;  ///< [m]
    double filter = 0;    ///< as a pressure probe's [s]
    /// A level above it is an event in waves [m]; minus infinity: none is counted.
    double deck = -std::numeric_limits<double>::infinity();
};

/// A box in which the volume of water is recorded; in two dimensions it has no ends along y.
struct WaterBox {
    std::string name;
    Box box;  ///< [m]
};

struct Sampling {
    double interval = 0;   ///< between frames (raster, metrics) [s]
    double mean_from = 0;  ///< settled means are not begun before this time [s]
    RasterSpec raster;
    std::vector<PressureProbe> pressure;
    std::vector<HeightProbe> height;
    std::vector<WaterBox> volumes;
    std::vector<double> cuts_x, cuts_y;  ///< planes in which the free surface is reported [m]
    double snapshot_interval = 0;        ///< ParaView files [s]; 0: of the last moment alone, below 0: none
};

struct Run {
    double duration = 0;        ///< [s]; where the run stops as soon as its loads have settled, the most it may take
    std::string stop = "auto";  ///< what ends it: settled, duration; while the scene is read also auto
    double wave_period = 0;     ///< of the waves that the start leaves, for the means of such a run [s]; 0: none
    bool stops_when_settled() const { return stop == "settled"; }
    std::vector<std::string> methods = method_names();
    int threads = 0;             ///< 0: all cores
    int ranks = 1;               ///< processes that share the particles
    std::string device = "cpu";  ///< what makes the particles' steps: cpu, gpu, auto (sph_solver/on_gpu.h)
    double checkpoint = 0;       ///< between SPH checkpoints [s of simulated time]
};

struct FvmOptions {
    double max_courant = 0, max_alpha_courant = 0;  ///< as written, else 4 in a stream and 1 without [-]
    double interface_compression = 2;               ///< cAlpha [-]
    std::string interface = "mules";                ///< how the water's surface is captured: mules, isoadvector
    bool captures_geometrically() const { return interface == "isoadvector"; }
    int correctors = 3;
    std::string body_mesh = "auto";  ///< how the mesh follows a body that moves: auto, morphing, whole (mesh_motion.h)
    std::string openfoam;            ///< folder of an OpenFOAM installation; empty: found
};

/// Water at the start, besides the still-water half space of a stream scene.
using WaterBlocks = std::vector<Box>;

struct Scene {
    std::string title;
    std::filesystem::path file;  ///< the scene file
    std::string text;            ///< its content as read
    std::string hash;            ///< of every number both methods use (not of title, paths, comments)
    std::optional<Hull> hull;
    std::vector<Obstacle> obstacles;
    std::vector<MovingBody> bodies;
    std::optional<MovingFrame> tank_motion;  ///< the scene's axes are the tank's; none: it rests in the earth
    WaterBlocks water_blocks;                ///< empty in a stream scene: all below z = 0 outside the hull
    Water water;
    Motion motion;
    Domain domain;
    ZoneOptions zones;
    WaveOptions wave_asked;
    std::optional<RegularWave> wave;  ///< as it is made; none: there is no regular one
    std::optional<Sea> sea;           ///< a sum of linear waves as it is made; none: there is none
    bool has_wave() const { return wave || sea; }
    /// Of the twin of a scene with a wave (scene/wave_twin.h): by method the run hash of that scene. Empty: this is no
    /// twin.
    std::map<std::string, std::string> wave_twin_of;
    Resolution resolution;
    std::vector<RefinedPlace> refined;
    std::vector<RefinementBox> refinement;  ///< those and what the hull asks for
    Sampling sampling;
    std::vector<MeasuredValue> measured;
    std::size_t measured_of_others = 0;  ///< rows of other speeds, waves, hulls or trims, left out
    Run run;
    SphOptions sph;
    FvmOptions fvm;
    std::vector<EffectChoice> effects;
    std::map<std::string, std::string> places;  ///< where the keys that were given stand, see place_of

    /// `file:line:column: [section] key = value` of "section.key", for messages about what is found later.
    std::string place_of(const std::string& key) const;
    /// Throws std::logic_error for a name that no effect has.
    bool effect_on(const std::string& name) const;
    bool hull_is_free() const { return hull && hull->free; }
    int symmetry_factor() const { return hull && hull->half ? 2 : 1; }
    /// What is solved reaches over this many metres of span; results of two dimensions are divided by it [m]. Of three
    /// dimensions 1: they are not divided.
    double span() const { return domain.dimensions == 2 ? domain.box.size().y() : 1; }
    /// The unit of something that two dimensions give per metre of span: "N" is "N/m" there.
    std::string spanwise_unit(const std::string& unit) const { return domain.dimensions == 2 ? unit + "/m" : unit; }
};

/// The changes that a command line may make before the scene is checked.
struct SceneOverrides {
    std::optional<std::filesystem::path> hull_file;
    std::optional<double> speed, spacing, near_hull, duration;  ///< [m/s], [m], [m], [s]
    std::optional<double> trim;                                 ///< [rad]
    std::optional<double> wave_length = {};                     ///< of a regular wave [m]
    std::optional<double> scale_resolution = {};                ///< multiplies both sizes, see Resolution [-]
    double sound_speed_factor = 1;                              ///< multiplies c0 [-]
    double time_step_factor = 1;                                ///< multiplies the acoustic Courant number of SPH [-]
    double courant_factor = 1;                                  ///< multiplies both Courant numbers of the FVM [-]
    /// Multiplies the distances at which the box of a hull in a stream ends: ahead, behind, sides and floor; never a
    /// symmetry plane, a bed or the top. The particles' sound speed stays as without it.
    double box_factor = 1;                     ///< [-]
    std::map<std::string, bool> effects = {};  ///< effects forced on or off
    std::string device = {};                   ///< empty: the scene's
    std::string interface = {};                ///< how the mesh method captures the surface; empty: the scene's
    bool wave_twin = false;                    ///< the twin of a scene with a wave in its place (scene/wave_twin.h)
};

/// Reads, fills in and checks a scene file. Throws InputError `file:line:column: ...` for the first thing that is
/// wrong.
Scene read_scene(const std::filesystem::path& file, const SceneOverrides& overrides = {});

/// The predicted cost of one method's run.
struct MethodCost {
    std::string method = {};
    double elements = 0;            ///< particles of water and air in the mean of the run, or cells [-]
    double with_walls = 0;          ///< those, and the particles in walls [-]
    double most = 0;                ///< of those for which there must be memory [-]
    double seconds = 0, bytes = 0;  ///< wall time on cores without other work [s], [bytes]
    double core_seconds = 0;        ///< processor time of all its cores [s]; 0: a GPU makes the steps
    double steps = 0;               ///< of time, of several sizes of particles those of the largest [-]
    std::string in_words = {};      ///< of the elements: "4.56e+04 particles + 1.2e+03 in walls"
    /// Keys of the method's own section that may make a run long, and by how many times their values do so here.
    std::vector<std::pair<std::string, double>> lengthened_by = {};
};
/// Predicted size of a run, from the geometry and a throughput table; no solving.
struct Prediction {
    /// Of water, in the mean of a run whose water runs into finer zones (scene/particles/particles_of_sizes.h).
    double particles = 0;                               ///< [-]
    double particles_at_start = 0, most_particles = 0;  ///< of water: then, and for which there must be memory [-]
    double wall_particles = 0, air_particles = 0, cells = 0;  ///< [-]
    double frames = 0, raster_bytes = 0;  ///< samples of the water raster [-] and their memory [bytes]
    double snapshots = 0;                 ///< moments at which ParaView files are written [-]
    std::vector<MethodCost> costs;        ///< of each method that was asked

    const MethodCost& of(const std::string& method) const;  ///< throws std::logic_error: it was not asked
};
/// How one method's run is predicted, see predict_particles. `pace`: how long this machine takes for work that
/// the table of `cost_estimate.cpp` calls one second. `size`: all but the costs.
struct CostOf {
    std::string method;
    MethodCost (*predict)(const Scene& scene, const Prediction& size, double pace) = nullptr;
    double pace = 1;  ///< [-]
};
Prediction predict(const Scene& scene, const std::vector<CostOf>& methods);
/// The same in two: all but the costs, and the cost of one method.
Prediction predict_sizes(const Scene& scene);
void add_cost(Prediction& size, const Scene& scene, const CostOf& method);
MethodCost predict_particles(const Scene& scene, const Prediction& size, double pace);
MethodCost predict_cells(const Scene& scene, const Prediction& size, double pace);
/// Peak of a whole run of 5500 particles with its report and pictures (/usr/bin/time -f %M); the solver's part of it is
/// 54 MB, and ends before.
inline constexpr double bytes_of_report = 164e6;
/// Throws InputError where the mesh method cannot solve what the scene asks for (see also mesh_motion.h).
void refuse_unmeshable(const Scene& scene);
/// The checked scene in words: hull, domain, resolution, sampling, effects with reasons, predicted cost.
std::string to_text(const Scene& scene, const Prediction& prediction);

}  // namespace tw

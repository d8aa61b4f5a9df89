#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "foam_cases/flavour.h"
#include "record/hull_motion.h"
#include "record/run_record.h"
#include "scene/box/forcing_zones.h"
#include "scene/box/inlet_wave.h"
#include "scene/mesh/edge_refinement.h"
#include "scene/mesh/mesh_motion.h"
#include "scene/scene.h"

namespace tw {

/// A side of the domain as an OpenFOAM patch.
struct Patch {
    std::string name;
    Side side = Side::slip_wall;
    bool empty = false;  ///< front and back of a 2-D scene
    bool holds = false;  ///< a tank's wall to which the water sticks
    /// Where the whole mesh moves with a body the tank's walls do not stay: a side is then open to water (and air) at
    /// rest, through which the mesh moves, or, up and down only, the floor alone.
    enum class Open { no, resting_water, water_and_air } open = Open::no;
    bool plane() const {
        return empty || (open == Open::no && ((side == Side::slip_wall && !holds) || side == Side::symmetry));
    }
    std::string mesh_type() const { return empty ? "empty" : plane() ? "symmetryPlane" : holds ? "wall" : "patch"; }
};

/// One axis of the background mesh: blocks between planes, each with a whole number of cells.
struct AxisCells {
    std::vector<double> planes;  ///< [m], ascending
    std::vector<int> cells;      ///< one fewer than planes
    std::vector<double> grows;   ///< of each block: size of its last cell over that of its first [-]
};
/// A closed surface that is cut out of the mesh.
struct Solid {
    std::string name;  ///< patch, and constant/triSurface/<name>.stl
    Surface surface;
    bool is_hull = false, moves = false;
};

/// A body that the mesh follows.
struct BodyInMesh {
    std::string patch;  ///< an OpenFOAM word
    MovingBody body;
    /// Name of the function object that writes its forces.
    std::string forces() const { return "forces_" + patch; }
};

/// Zones that draw the flow to a velocity (foam_cases/forcing_zones).
struct ZoneSource {
    Vec3 velocity = Vec3::Zero();  ///< [m/s]
    std::vector<ForcingZone> zones;
    std::optional<WaveSum> wave = {};        ///< that some of them make
    std::optional<WaveComponents> sea = {};  ///< likewise, a sum of linear waves
};

/// Everything that follows from the scene and that more than one OpenFOAM file needs. It points into the scene, which
/// must outlive it.
struct CasePlan {
    const Scene* scene = nullptr;
    Flavour flavour;

    // geometry
    std::array<Patch, 6> sides;  ///< x_min, x_max, y_min, y_max, z_min, z_max
    std::array<AxisCells, 3> axes;
    std::vector<Solid> solids;         ///< the hull first
    std::vector<RefinementBox> boxes;  ///< names are OpenFOAM words, each once
    bool snappy = false;               ///< something has to be cut out or refined
    bool extrude = false;              ///< two dimensions with solids: one layer is drawn out of the slab's front
    int wet_level = 0, surface_level = 0, feature_level = 0;
    EdgeRefinement shedding;                      ///< finer cells along the edges from which the stream leaves the hull
    std::string ribbon;                           ///< name of their surface, an OpenFOAM word; empty without such edges
    double background_cell = 0, finest_cell = 0;  ///< [m]; the finest but for those along shedding edges
    Vec3 point_in_fluid = Vec3::Zero();           ///< [m]
    bool half_space = true;                       ///< water: all below z = 0 (else the scene's water blocks)

    // bodies that move, or a hull that is free
    MeshMotion mesh_motion;
    std::vector<BodyInMesh> bodies;   ///< that the mesh follows
    double relaxation = 1;            ///< of their accelerations, in each outer corrector [-]
    double newmark_gamma = 0.5;       ///< of the rule that moves them [-]; 1 damps what swings from step to step
    double release_factor = 1;        ///< on the scene's velocity at the release [-] (run/first_steps.h)
    /// That holds a free hull until its release (foam_cases/held_body); empty: it is free at once, or there is none.
    std::string hold_library;
    std::string hull_release;         ///< what is said of it in the record; empty without a free hull
    int outer_correctors = 1;         ///< in which mesh, flow and bodies are solved once more in each step
    int pressure_correctors = 1;      ///< in each of them
    bool momentum_predictor = false;  ///< before them, where water is viscous (viscous_steps.h)
    bool mesh_moves() const { return !bodies.empty(); }
    bool several_bodies() const { return bodies.size() > 1; }
    /// Whether the record's table of forces counts the load on a solid: on the hull alone, or on all where there is
    /// none.
    bool counts_load_on(const Solid& solid) const { return solid.is_hull || !scene->hull; }
    /// The only one, or the first of several.
    const MovingBody& moving() const { return bodies.at(0).body; }
    /// interFoam, or what stands for it in the flavour; interIsoFoam where the surface is captured geometrically.
    std::string solver_program() const {
        return scene->fvm.captures_geometrically() ? geometric_solver : flavour.solver_program();
    }
    /// Of the record, in which its motion stands.
    std::string motion_table(const BodyInMesh& body) const {
        return scene->hull_is_free() ? hull_motion_table : body_table(body.body.name);
    }
    /// Of what is solved: a half model's body weighs half, a section as much as the mesh is thick.
    double solved_share() const { return scene->span() / scene->symmetry_factor(); }

    // physics
    bool stream = false, viscous = false, no_slip = false, turbulent = false;
    /// Of the walls that let water go (foam_cases/ventilated_wall); empty: solids hold water under tension.
    std::string wall_library;
    std::string walls;                    ///< what holds of them, for the record
    double inlet_k = 0, inlet_omega = 0;  ///< [m2/s2], [1/s]
    ZoneSource zones;                     ///< that absorb waves
    std::optional<InletWave> inlet_wave;  ///< a wave that enters with the stream
    std::string zone_library;             ///< of both (foam_cases/forcing_zones); empty without zones and such a wave

    // time
    double write_interval = 0;  ///< [s]; hull pressures (and so the water's force) are sampled at it
    /// A tank, or a hull held in a stream: written at the step nearest to each write time. Else each is met exactly,
    /// for which OpenFOAM splits the time between two of them evenly; where that is a few steps only, sampling sets the
    /// step.
    bool writes_at_steps = false;
    int time_precision = 8;     ///< digits in a write time's name
    int raster_every = 1;       ///< water is poured into the raster at every n-th write
    int snapshot_every = 0;     ///< ParaView surfaces are kept at every n-th write; 0: of the last one only
    double plate_interval = 0;  ///< at which pressures on an elastic plate are kept [s]; 0: there is none
    double first_step = 0, largest_step = 0;  ///< [s]
    struct StepCap {
        double until, step;  ///< [s]
    };
    std::vector<StepCap> step_caps;  ///< of bodies released at rest: steps are no longer than this at first
    double water_speed_limit = 0;    ///< ten times what the scene explains [m/s]; infinite where nothing moves
    /// Of the air that is pressed out of a gap of one cell, three times over [m/s]: across a gap h that closes with V
    /// it leaves with V L / 2h, L the length of the largest solid or, without one, of the domain.
    double air_speed_limit = 0;  ///< [m/s]; 0: none

    // probes
    std::vector<Vec3> pressure_places;  ///< [m], moved into the flow by 5 % of a cell where a wall is near
    struct ColumnPoint {
        Vec3 place;     ///< [m]
        double height;  ///< share of the column that it stands for [m]
    };
    std::vector<std::vector<ColumnPoint>>
        height_columns;  ///< per height probe: the middles of the cells of a column, floor to top
};

}  // namespace tw

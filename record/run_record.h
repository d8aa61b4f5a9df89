#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "meshes/surface.h"
#include "record/effect_choice.h"
#include "record/raster_spec.h"
#include "record/resolution.h"
#include "record/table.h"

namespace tw {

/// Share of each voxel that is water, 0..255 for 0..1, x fastest; see RasterSpec.
struct RasterFrame {
    double time = 0;                  ///< [s]
    std::vector<std::uint8_t> water;  ///< one for each voxel
};

struct Phase {                 ///< where the time went
    std::string name;          ///< "set-up", "meshing", "solving", "output"...
    double wall = 0, cpu = 0;  ///< [s]
};

/// One validity check of a run (certificate): the largest value of something that has to stay below a limit, when and
/// where.
struct RecordedCheck {
    std::string name, unit;
    double value = 0, limit = 0;                                            ///< [unit]
    double time = 0;                                                        ///< [s]
    Vec3 place = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());  ///< [m]; NaN where it belongs to no place
    bool met() const { return value <= limit; }
};

/// A body that moves, as it stood at the start; where it was later says the table of its motion (body_pose.h).
struct BodyShape {
    std::string table;           ///< "body_NAME", or "hull_motion" of a hull that is free in a stream
    Surface surface;             ///< [m]; of two dimensions a metre wide
    Vec3 centre = Vec3::Zero();  ///< of mass [m]
};

/// What one run leaves: the same layout for SPH, FVM and any other source. One HDF5 file, written atomically.
///
/// Tables every source fills as far as it can (whole hull: symmetry already applied, see attribute symmetry_factor):
///   forces:  fx, fy, fz [N]       force of the water on the hull (the compared one); in a tank without a hull on all
///                                 solids in it together, those that move among them
///            fx_pressure.. fz_pressure, fx_viscous.. fz_viscous [N]
///            my [N m]             moment about the pose's reference point (attribute moment_reference "x y z"), bow up
///            positive SPH: fx_surface, fz_surface (surface-pressure integral), fx_volume, fz_volume (control volume)
///            FVM: fx_total, fz_total (air included); fx_air, fz_air, also SPH with air
///   samples: mass, kinetic_energy, potential_energy, dt, max_mach | max_courant, max_speed, particles | cells,
///            particles_in, particles_out, particles_lost, wetted_length [m], ventilation [-], wetted_area [m2]
///   pressure, height: one column per probe of the scene; volume: one per box, see record/water_in_box.h
///   body_NAME: of each body that moves, one row per step: x, y, z of its centre of mass and `lowest`, height of its
///            lowest point [m]; q0, qx, qy, qz, the quaternion that turns it from how it stood at first; vx.. [m/s],
///            spin_x.. [rad/s]; fx.., mx.. force of the water and its moment about the centre of mass [N, N m], earth
///            axes, and fx_body.., mx_body.. the same in axes that turn with the body and were the earth's at the start
///            of a plate that bends also its gauges: strains under the gauge's name, displacements NAME_x.. [m]; of its
///            rigid counterpart in a method that cannot bend it the same, found one way (attribute one_way)
///   plate_pressure_NAME: pressures on that counterpart, one column per element of the plate [Pa]
///   hull_motion: of a hull that is free in a stream, one row per step, see record/hull_motion.h
///   level_0, level_1, ...: of each of several sizes of particles, coarsest first, one row per frame: spacing [m], dt
///            [s]; active particles; band and carried, which stand for finer ones; guards, which stand for coarser
///            ones; births and deaths at the edge of its zone since the start; spray beyond that edge; orphans, particles
///            of its edge without water of the other size near; mass_drift of the zone since the start [%]
/// A value that a method does not know at some time is NaN; a column it never knows is absent.
struct RunRecord {
    static constexpr int format_version = 1;

    /// method ("sph", "fvm", ...), title, scene_hash, hull_hash, hull_source, code_version, compiler, machine, threads,
    /// ranks, isa, device (the GPU that made the steps), gpu_left_alone (why none did, of "auto"), openfoam, started, symmetry_factor, moment_reference, calibrated,
    /// structure ("elastic", "rigid", "rigid, strains one way": of a scene with a body that bends), ...
    std::map<std::string, std::string> attributes;
    /// spacing h, length, beam, draft, trim, speed, density, gravity, duration, mean_from, h_over_dp, c0, alpha, ...
    /// level_0_seconds, ...: wall time of the sweeps of each size of particles since the run was begun or resumed;
    /// level_1_edge_seconds, ...: of what passes between it and the next larger size
    /// structure_seconds: processor time of bodies that bend, the water's forces on their dummies and their own steps,
    /// since then
    std::map<std::string, double> numbers;
    std::string scene_text;

    std::map<std::string, Table> tables;
    RasterSpec raster;
    std::vector<RasterFrame> frames;
    /// Pressure on the hull at the last frame, for the pictures: triangles of the posed hull and one value each.
    Surface hull;
    std::vector<float> hull_pressure, hull_wet;  ///< per triangle [Pa], [0..1]; empty when unknown
    std::vector<BodyShape> bodies;               ///< that move and keep their shape; none in older records
    std::vector<Phase> phases;
    double peak_memory = 0;          ///< [bytes]
    double elements = 0, steps = 0;  ///< particles or cells [-]; time steps
    std::vector<EffectChoice> effects;
    std::vector<RecordedCheck> validity_checks;  ///< of the whole run, begun and resumed; empty in older records
    /// The domain with its largest size, and where the run was finer at its end; empty where it is not known.
    std::vector<ResolvedBox> resolution;

    std::string state = "running";  ///< "running", "finished", "stopped", "failed"
    std::string reason;             ///< why it stopped or failed

    Table& table(const std::string& name);
    const Column* series(const std::string& table, const std::string& column) const;
    /// Forgets the rows and frames after `time` [s]: a run goes on from there.
    void rewind(double time);
};

/// The table of a body that moves.
inline std::string body_table(const std::string& name) { return "body_" + name; }
/// The number that says over which time [s] the peak of a probe ("pressure", "height") or a "body" is a mean.
inline std::string peak_filter(const std::string& table, const std::string& name) {
    return "peak_filter_" + table + "_" + name;
}
/// The table of one of several sizes of particles, coarsest first.
inline std::string level_table(std::size_t k) { return "level_" + std::to_string(k); }

/// Writes one HDF5 file, atomically, followed by a line with the SHA-256 of its bytes (HDF5 readers ignore it;
/// read_record knows damage by it). Throws RunError: disk full, no permission, or a column that is not as long as its
/// table's time.
void write_record(const std::filesystem::path& file, const RunRecord& record);
/// Throws InputError: not there, not HDF5, not a run record, newer format, cut off, damaged (the dataset is named), or
/// with scalars that cannot be (check_values.h).
RunRecord read_record(const std::filesystem::path& file);

}  // namespace tw

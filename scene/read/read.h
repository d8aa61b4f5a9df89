#pragma once
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "base/numbers.h"
#include "scene/read/scene_section.h"
#include "scene/scene.h"

namespace tw {

// The readers of the sections: text -> typed values in SI. Keys that stand in the scene as they are written go there by
// SceneSection::read_into; what is left to be worked out is returned. Each throws InputError at the key and ends in
// SceneSection::finish().

/// All sections of one scene file; kept while the scene is being checked so that a later finding names its key.
struct Sections {
    SceneSection root, hull, water, motion, wave, resolution, domain, run, sampling, tank, effects;
    std::map<std::string, SceneSection> numerics;  ///< of each method, by its name
    std::vector<SceneSection> obstacles, bodies, probes, water_blocks, refined, plies, gauges, volumes, measured;
};
Sections split_sections(const std::filesystem::path& file, const TextValue& document);

std::optional<double> read_water(SceneSection& s, Scene& scene);                  ///< depth of the place [m]
std::optional<double> read_motion(SceneSection& s, Scene& scene, bool has_hull);  ///< ramp [s]

/// Works out scene.wave or scene.sea from what is asked for, once the tank and its water are known.
void settle_wave(Scene& scene, Sections& s);
/// What an oblique wave needs around it, and of its stream (scene/box/oblique_wave.h). Throw InputError.
void refuse_oblique_surroundings(const Scene& scene, Sections& s, double degrees);
void check_oblique_wave(const Scene& scene, Sections& s, const std::string& size);
/// Checks of the wave that need sizes and effects. Throws InputError.
void check_wave(const Scene& scene, Sections& s);

struct ResolutionOptions {
    std::optional<double> spacing, near_hull;  ///< [m]
};
ResolutionOptions read_resolution(SceneSection& s);

struct DomainOptions {
    std::optional<double> ahead, behind, side, below, above;  ///< [m]
    std::optional<std::pair<double, double>> x, y, z;
    int dimensions = 3;
    bool empty() const { return !ahead && !behind && !side && !below && !above && !x && !y && !z; }
};
DomainOptions read_domain(SceneSection& s);
std::optional<Box> read_tank(SceneSection& s);  ///< nothing when there is no [tank]
/// Before `read_tank`: the motion of a tank that has one.
std::optional<MovingFrame> read_tank_motion(SceneSection& s, int dimensions);
/// An angle at which something stands beyond which a number without a unit is asked back: half a radian is 28.6
/// degrees.
inline constexpr double largest_plain_angle = 15 * degree;  ///< [rad]
/// "0.5 is 0.5 rad = 28.6 degrees, more than 15; expected \"0.5 deg\", or \"28.6 deg\" where that is meant"; empty
/// where the angle has a unit or is smaller.
std::string why_angle_is_asked_back(const SceneSection& s, const std::string& key, double angle);
/// The keys from `law` on, of a body or a tank. `flat`: in the plane y = 0.
MotionLaw read_motion_law(SceneSection& s, bool flat);

/// The places of the scene's [[refine]] sections, after its domain is made. Throws InputError at the key that is wrong.
std::vector<RefinedPlace> read_refined(std::vector<SceneSection>& sections, const Scene& scene);

/// Edge of the raster's voxels [m].
std::optional<double> read_sampling(SceneSection& s, std::vector<SceneSection>& probes, Scene& scene);
/// The sections [[volume]]. Throws InputError where two have one name, or a box has no volume.
std::vector<WaterBox> read_volumes(std::vector<SceneSection>& sections);
/// A section [[measured]]: the value, and the scenes that it belongs to.
struct MeasuredRow {
    MeasuredValue value;
    std::optional<double> speed,
        wave_length;  ///< of the stream [m/s], of a regular wave [m]; none: as in the scene file
};
/// Of a scene whose motion and wave are read. Throws InputError where one is not whole, or two are of one quantity at one
/// speed in one wave.
std::vector<MeasuredRow> read_measured(std::vector<SceneSection>& sections, const Scene& scene);
/// Puts those that belong to the checked scene into it: not those of another speed or wave length, nor, where they name
/// none, those whose scene the command line has changed in that or in hull or trim.
void take_measured(std::vector<MeasuredRow> rows, const SceneOverrides& changed, Scene& scene);

/// The hull as it stands in the water; health is checked later, when the particle spacing is known.
struct FreeHullOptions {
    DegreesOfFreedom free;
    double mass = 0;                                    ///< [kg]
    std::optional<double> lcg, vcg, gyradius, release;  ///< [m], [m], [m], [s]
};
struct HullOptions {
    Hull hull;
    Surface as_read;  ///< before posing [m]: what the health check looks at
    Pose pose;
    bool repair = false;
    std::string key;  ///< "file" or "shape": where findings about the surface are reported
    std::optional<FreeHullOptions> free;
    std::vector<Finding> notes;  ///< of what was done while reading
};
HullOptions read_hull(SceneSection& s);
/// The keys of a hull that is free; nothing for one that is held.
std::optional<FreeHullOptions> read_free_hull(SceneSection& s);
/// Gives such a hull its mass and centre where it stands.
void stand_free_hull(HullOptions& o, double water_density);
/// The turn from the shape's own axes to those in which it stands.
Eigen::Matrix3d turn_of(const Pose& pose);
/// The surface of [hull], [[obstacle]] or [[body]] in metres, before it is posed: from `file` or from `shape` and its
/// parameters. `source`: that file or shape as written; `key`: which of the two it was.
Surface read_solid(SceneSection& s, std::string& source, std::string& key);
/// The same, refused where it is not closed or not sound: of what has no `repair` of its own.
struct SoundSolid {
    Surface surface;
    std::optional<Finding> note;  ///< as solids_note
};
SoundSolid read_sound_solid(SceneSection& s, std::string& source, std::string& key);
/// Throws InputError with the first error among the findings, `remedy` of it, and the names of the file's solids where
/// it has several.
void refuse_unsound(const std::vector<Finding>& findings, const SceneSection& s, const std::string& source,
                    const std::string& key, const std::function<std::string(const Finding&)>& remedy);
/// Of a surface with several shells: the names of the solids that its file has.
std::optional<Finding> solids_note(const std::vector<Finding>& findings, const SceneSection& s,
                                   const std::string& source);
// What of a body is not read by its slots: of a rigid one, an elastic plate, an elastic tyre (with its surface as it
// stands at the start, blown up).
void read_body(SceneSection& s, MovingBody& b, int dimensions);
void read_plate_body(SceneSection& s, MovingBody& b, ElasticPlate plate);
void read_tyre_body(SceneSection& s, MovingBody& b, ElasticTyre tyre);
/// The elastic ones among the bodies, each with its plies and gauges; nothing for the others.
std::vector<std::optional<ElasticPart>> read_elastic(std::vector<SceneSection>& bodies,
                                                     std::vector<SceneSection>& plies,
                                                     std::vector<SceneSection>& gauges, int dimensions, double gravity);
ElasticTyre read_tyre(SceneSection& s, int dimensions, double gravity);
/// Gives an elastic plate what follows from the particle spacing: skin, margin, surface and rigid counterpart.
void stand_elastic(MovingBody& body, double dp, SceneSection& s);
/// A solid from a file, a shape or a box (min, max).
Obstacle read_obstacle(SceneSection& s, std::size_t number);
std::vector<Box> read_water_blocks(std::vector<SceneSection>& sections);
/// `min` and `max` of a section, both required.
Box read_box(SceneSection& s);

}  // namespace tw

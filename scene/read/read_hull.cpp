#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/errors.h"
#include "meshes/axis_turn.h"
#include "meshes/generate.h"
#include "meshes/read/drawing_unit.h"
#include "meshes/read/named_solid.h"
#include "meshes/read/solids_of_file.h"
#include "meshes/surface.h"
#include "scene/read/read.h"
#include "scene/solids/hull_axes.h"

namespace tw {
namespace {
constexpr double least_draft = 0.01;  // of the hull's height: with less its file has the keel at z = 0

/// A file of the command line is where the user stands, one of the scene beside the scene.
std::filesystem::path path_of(const SceneSection& s, const std::string& source) {
    return s.from_option("file") ? std::filesystem::path(source) : s.file().parent_path() / source;
}

/// Of a drawing: the unit that it was read in.
std::optional<Finding> unit_note(const SceneSection& s, const std::string& source) {
    if (!s.has("file")) return {};
    const std::filesystem::path path = named_solid(path_of(s, source)).file;
    if (!is_drawing(path)) return {};
    return Finding{
        Finding::Level::note, "drawing_unit",
        fmt::format("the drawing {} is in {}, by its own header", path.filename().string(), unit_of_drawing(path)),
        Vec3::Zero()};
}

/// Of a file that is taken as a whole and names several bodies: which these are.
std::optional<Finding> solids_of_source(const SceneSection& s, const std::string& source) {
    if (!s.has("file")) return {};
    const auto [file, name] = named_solid(path_of(s, source));
    if (!name.empty()) return {};
    const std::vector<SolidNames> solids = solids_of_file(file);
    const std::vector<std::string> bodies = names_of_bodies(solids);
    if (bodies.size() < 2) return {};
    return Finding{Finding::Level::note, "several_solids",
                   fmt::format("{} names several solids, which are taken together: {}; file = \"{}#{}\" takes one",
                               file.filename().string(), names_in_words(solids), source, bodies.front()),
                   Vec3::Zero()};
}

}  // namespace

std::string why_angle_is_asked_back(const SceneSection& s, const std::string& key, double angle) {
    if (!s.without_unit(key) || std::abs(angle) <= largest_plain_angle) return {};
    return fmt::format(
        "a number without a unit is in radians, and this is {:.3g} degrees, more than 15; expected \"{:.6g} "
        "deg\", or \"{:.6g} rad\" where that is meant",
        angle / degree, angle, angle);
}

Surface read_solid(SceneSection& s, std::string& source, std::string& key) {
    const std::filesystem::path& scene_file = s.file();
    const auto file = s.text("file");
    const auto shape = s.choice("shape");
    const auto unit_given = s.choice("unit");
    const std::string unit = unit_given.value_or("m");
    const std::string axes = s.text("axes", "xyz");
    if (file && shape) s.fail("shape", "given twice: also file; keep one of the two");
    if (!file && !shape) s.fail("file", "missing; expected file = \"hull.stl\" or shape = \"prismatic\"");
    key = file ? "file" : "shape";
    source = file ? *file : *shape;
    try {
        if (file) {
            const std::filesystem::path path = path_of(s, *file);
            const std::filesystem::path whole = named_solid(path).file;  // of file#solid
            if (!std::filesystem::exists(whole)) s.fail("file", fmt::format("there is no file {}", whole.string()));
            if (unit_given && is_drawing(whole))
                s.fail("unit",
                       fmt::format("{} is a drawing in {}, by its own header, and is read in them; expected no unit "
                                   "beside it",
                                   whole.filename().string(), unit_of_drawing(whole)));
            return read_surface(path, unit, axes);
        }
        const auto found = std::ranges::find(hull_shapes(), *shape, &HullShape::name);
        std::map<std::string, double> values;
        for (const HullParameter& p : found->parameters)
            values[p.name] = s.number(p.name, p.fallback, p.kind, {p.min, p.max});
        Surface made = make_hull(*shape, values);
        turn_axes(made, axis_turn(axes));
        return made;
    } catch (const InputError& e) {
        if (std::string(e.what()).starts_with(scene_file.string() + ":")) throw;
        s.fail(key, e.what());
    }
}

void refuse_unsound(const std::vector<Finding>& findings, const SceneSection& s, const std::string& source,
                    const std::string& key, const std::function<std::string(const Finding&)>& remedy) {
    for (const Finding& f : findings) {
        if (f.level != Finding::Level::error) continue;
        const auto solids = solids_of_source(s, source);
        s.fail(key, fmt::format("{}: {}{}{}", f.name, f.message, remedy(f), solids ? "; " + solids->message : ""));
    }
}

std::optional<Finding> solids_note(const std::vector<Finding>& findings, const SceneSection& s,
                                   const std::string& source) {
    const bool several = std::ranges::find(findings, "several_shells", &Finding::name) != findings.end();
    return several ? solids_of_source(s, source) : std::nullopt;
}

SoundSolid read_sound_solid(SceneSection& s, std::string& source, std::string& key) {
    SoundSolid solid{read_solid(s, source, key), {}};
    const std::vector<Finding> findings = check_surface(solid.surface);
    refuse_unsound(findings, s, source, key, [](const Finding& f) {
        return f.mendable ? "; \"twinwake hull repair FILE NEW.stl\" repairs it" : "";
    });
    solid.note = solids_note(findings, s, source);
    return solid;
}

HullOptions read_hull(SceneSection& s) {
    HullOptions o;
    Hull& hull = o.hull;
    hull.trim = s.number("trim", hull.trim);
    hull.heel = s.number("heel", hull.heel);
    for (const auto& [key, angle] : {std::pair{"trim", hull.trim}, {"heel", hull.heel}})
        if (const std::string why = why_angle_is_asked_back(s, key, angle); !why.empty()) s.fail(key, why);
    const auto draft = s.number("draft");
    Pose& pose = o.pose;
    if (const auto position = s.numbers("position")) pose.position = {(*position)[0], (*position)[1], 0};
    hull.half = s.flag("half", hull.half);
    o.repair = s.flag("repair", o.repair);
    if (hull.half && hull.heel != 0)
        s.fail("half", "a heeled hull is not symmetric about y = 0; set heel = 0 or half = false");
    o.as_read = read_solid(s, hull.source, o.key);
    if (const auto of_file = unit_note(s, hull.source)) o.notes.push_back(*of_file);
    if (const auto mirrored = mirror_half(o.as_read)) o.notes.push_back(*mirrored);
    o.free = read_free_hull(s);
    s.finish();
    // Without a draft the hull keeps the height it has in its own file.
    hull.draft = draft.value_or(-o.as_read.bounds().min.z());
    if (!(hull.draft > 0))
        s.fail("draft", fmt::format("the hull is not in the water: its lowest point stands {:.6g} m above still water; "
                                    "expected draft > 0, the depth of the lowest point below z = 0",
                                    std::abs(hull.draft)));
    const double height = o.as_read.bounds().size().z();
    if (!draft && hull.draft < least_draft * height)
        s.fail(o.key, fmt::format("the hull barely touches the water: in its own coordinates its lowest point lies "
                                  "{:.3g} m below still water, and it is {:.3g} m high; give draft, the depth of the "
                                  "lowest point below z = 0",
                                  hull.draft, height));
    pose.trim = hull.trim;
    pose.heel = hull.heel;
    pose.draft = hull.draft;
    hull.surface = posed(o.as_read, pose);
    return o;
}

Obstacle read_obstacle(SceneSection& s, std::size_t number) {
    Obstacle o;
    o.name = s.identifier("name", fmt::format("obstacle{}", number));
    const auto min = s.vector("min"), max = s.vector("max");
    if (min || max) {
        if (!min || !max) s.fail(min ? "max" : "min", "missing; a box needs min = [x, y, z] and max = [x, y, z]");
        const Box box{*min, *max};
        if (!(box.size().array() > 0).all())
            s.fail("max", "the box has no volume; expected max > min in every direction");
        o.surface = box_surface(box);
    } else {
        std::string source, key;
        o.surface = read_sound_solid(s, source, key).surface;
        const Vec3 position = s.vector("position").value_or(Vec3::Zero());
        for (Vec3& p : o.surface.points) p += position;
    }
    s.finish();
    return o;
}

}  // namespace tw

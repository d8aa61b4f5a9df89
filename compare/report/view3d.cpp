#include "compare/report/view3d.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "compare/metrics/raster_columns.h"
#include "compare/report/colours.h"
#include "compare/report/drawn_solids.h"
#include "compare/report/escape.h"
#include "compare/report/page.h"
#include "compare/report/pictures.h"
#include "methods/methods.h"
#include "record/record_numbers.h"
#include "record/water_surface.h"

namespace tw {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_steps = 60, fewest_steps = 24, most_hull_triangles = 65536, most_points_of_water = 65536;
/// Script, markup, legend and times need less than this of the section.
constexpr std::size_t markup_bytes = 650'000;
/// Places over the box's edges: of water, whose raster has fewer voxels, and of solids, whose edges are seen.
constexpr unsigned water_steps = 4095, solid_steps = 65535;
constexpr std::size_t pose_bytes = 16 * 26;  ///< sixteen numbers with all their digits

/// The frames of a source that can be drawn, in order of time.
std::vector<const RasterFrame*> drawable_frames(const RunRecord& record) {
    const RasterGrid grid(record.raster);
    std::vector<const RasterFrame*> frames;
    if (grid.empty() || !record.raster.origin.allFinite() || !std::isfinite(record.raster.voxel)) return frames;
    for (const RasterFrame& f : record.frames)
        if (std::isfinite(f.time) && f.water.size() == grid.voxels()) frames.push_back(&f);
    std::ranges::stable_sort(frames, {}, &RasterFrame::time);
    return frames;
}

bool is_mirrored(const RunRecord& record) {
    return number_of_text(record, "symmetry_factor", 1) > 1 && record.raster.count[1] > 1;
}

/// The raster's box; a half model's with its other side, a two-dimensional run's with the width of its slab.
Box raster_box(const RunRecord& record) {
    const auto& n = record.raster.count;
    Box box{record.raster.origin, record.raster.origin};
    box.max += record.raster.voxel * Vec3(n[0], n[1] == 1 ? 0.2 * n[0] + 1 : n[1], n[2]);
    if (is_mirrored(record)) box.min.y() = -box.max.y();
    return box;
}

/// What is drawn, whichever frames are chosen.
struct Stage {
    std::vector<std::vector<const RasterFrame*>> frames;  ///< per source
    std::vector<DrawnSolid> solids;                       ///< hulls and bodies
    Box box;                                              ///< of everything drawn
    Box path;  ///< of all that moves, over the frames; without volume where nothing does
    double first = std::numeric_limits<double>::infinity(), last = -first;  ///< ends of the slider [s]
    std::size_t most_frames = 0;                                            ///< of one source
};

void widen(Box& box, const Box& by) {
    box.min = box.min.cwiseMin(by.min);
    box.max = box.max.cwiseMax(by.max);
}

/// Where a solid is seen at the start and in each frame of its sources.
Box path_of(const Comparison& c, const Stage& stage, const DrawnSolid& solid) {
    Box path = solid.surface.bounds();
    for (std::size_t k = 0; k < solid.sources.size() && solid.moves(); ++k)
        for (const RasterFrame* frame : stage.frames[solid.sources[k]])
            if (const auto pose = body_pose(c.sources[solid.sources[k]], *solid.motions[k], frame->time))
                widen(path, (*pose)(solid.surface).bounds());
    return path;
}

Stage make_stage(const Comparison& c) {
    Stage stage;
    std::vector<Box> boxes, paths;
    for (std::size_t s = 0; s < c.sources.size(); ++s) {
        const RunRecord& r = c.sources[s];
        const auto& frames = stage.frames.emplace_back(drawable_frames(r));
        if (!frames.empty()) {
            stage.first = std::min(stage.first, frames.front()->time);
            stage.last = std::max(stage.last, frames.back()->time);
            stage.most_frames = std::max(stage.most_frames, frames.size());
            boxes.push_back(raster_box(r));
        }
    }
    stage.solids = drawn_solids(c, most_hull_triangles);
    for (const DrawnSolid& solid : stage.solids) {
        boxes.push_back(path_of(c, stage, solid));
        if (solid.is_body()) paths.push_back(boxes.back());
    }
    if (boxes.empty()) return stage;
    stage.box = boxes.front();
    for (const Box& b : boxes) widen(stage.box, b);
    if (!paths.empty()) stage.path = paths.front();
    for (const Box& b : paths) widen(stage.path, b);
    if (!stage.box.size().allFinite()) stage.most_frames = 0;  // senseless numbers: nothing is drawn
    return stage;
}

std::size_t nearest(const std::vector<const RasterFrame*>& frames, double time) {
    const auto after = std::ranges::lower_bound(frames, time, {}, &RasterFrame::time);
    const auto k = static_cast<std::size_t>(after - frames.begin());
    if (k == 0) return 0;
    return k == frames.size() || time - frames[k - 1]->time < frames[k]->time - time ? k - 1 : k;
}

/// The surfaces of one source that are in the page, and which of them each step of the slider shows.
struct Film {
    std::vector<std::size_t> frame;  ///< number among the source's drawable frames, increasing
    std::vector<std::size_t> step;   ///< per step, number in `frame`
    Json water;                      ///< the surfaces, as the script reads them
};
struct View {
    std::vector<double> times;  ///< of the steps [s]
    std::vector<Film> films;    ///< one per source
    int coarsening = 1;
    std::size_t bytes = 0;
    bool numbers_fit = true;  ///< 16 bits number the points of each surface
};

/// What the script needs of surfaces: their block, the numbers of their points and triangles, and how fine places are.
Json json_of(const SurfacePack& pack) {
    return {{"points", pack.points()},
            {"triangles", pack.triangles()},
            {"steps", pack.steps()},
            {"block", pack.size() > 0 ? pack.block() : ""}};
}

View make_view(const Comparison& c, const Stage& stage, std::size_t steps, int coarsening) {
    View view;
    view.coarsening = coarsening;
    for (std::size_t k = 0; k < steps; ++k)
        view.times.push_back(k + 1 == steps ? stage.last
                                            : stage.first + (stage.last - stage.first) * static_cast<double>(k) /
                                                                static_cast<double>(steps - 1));
    for (std::size_t s = 0; s < c.sources.size(); ++s) {
        Film& film = view.films.emplace_back();
        const auto& frames = stage.frames[s];
        SurfacePack pack(stage.box, water_steps);
        film.water = json_of(pack);
        if (frames.empty()) continue;
        for (std::size_t k = 0; k < steps; ++k) {
            const std::size_t frame = k + 1 == steps ? frames.size() - 1 : nearest(frames, view.times[k]);
            if (film.frame.empty() || film.frame.back() != frame) {
                const Surface water = water_surface(c.sources[s], *frames[frame], coarsening);
                view.numbers_fit = view.numbers_fit && water.points.size() <= most_points_of_water;
                if (!view.numbers_fit) return view;
                film.frame.push_back(frame);
                pack.add(water);
            }
            film.step.push_back(film.frame.size() - 1);
        }
        film.water = json_of(pack);
        view.bytes += film.water.dump().size();
    }
    return view;
}

/// As many steps as fit into the budget; where these are too few the raster is coarsened. Ends, because a raster
/// averaged into one voxel has no surface.
View fitting_view(const Comparison& c, const Stage& stage, std::size_t budget) {
    const std::size_t most = std::min(most_steps, stage.most_frames), fewest = std::min(fewest_steps, most);
    for (int coarsening = 1;; ++coarsening) {
        const std::size_t few = std::min<std::size_t>(most, 6);  // these say how large a step is
        const View sample = make_view(c, stage, few, coarsening);
        if (!sample.numbers_fit) continue;
        const double affordable = 0.9 * static_cast<double>(budget * few) / static_cast<double>(sample.bytes + 1);
        auto steps = static_cast<std::size_t>(std::min(static_cast<double>(most), affordable));
        for (; steps >= fewest; steps -= std::max<std::size_t>(1, steps / 10)) {
            View view = make_view(c, stage, steps, coarsening);
            if (view.numbers_fit && view.bytes <= budget) return view;
        }
    }
}

/// The rigid motion as the 16 numbers of a matrix, columns first; as at the start where it is not known.
Json pose_json(const std::optional<BodyPose>& pose) {
    Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
    if (pose) {
        m.topLeftCorner<3, 3>() = pose->turn.toRotationMatrix();
        m.topRightCorner<3, 1>() = (*pose)(Vec3::Zero());
    }
    return std::vector<double>(m.data(), m.data() + 16);
}

/// What the camera looks at: the hull, or the way of the bodies with as much water around, or everything.
Box subject_of(const Stage& stage) {
    if (!stage.solids.empty() && !stage.solids.front().is_body()) return stage.solids.front().surface.bounds();
    if (stage.solids.empty()) return stage.box;
    const Vec3 round = Vec3::Constant(0.4 * stage.path.size().maxCoeff());
    return {(stage.path.min - round).cwiseMax(stage.box.min), (stage.path.max + round).cwiseMin(stage.box.max)};
}

/// Where the triangles lie to which a source's pressures on a hull belong; null: it has none there.
const Surface* surface_of_pressures(const Comparison& c, const DrawnSolid& solid, std::size_t k) {
    const RunRecord& record = c.sources[solid.sources[k]];
    const Surface& recorded = solid.moves() ? solid.motions[k]->surface : record.hull;
    const bool known =
        !solid.is_body() && !record.hull_pressure.empty() && record.hull_pressure.size() == recorded.triangles.size();
    return known ? &recorded : nullptr;
}

/// The scale of the pressures, where a hull that is drawn has some.
std::optional<PressureRange> shown_pressures(const Comparison& c, const Stage& stage) {
    for (const DrawnSolid& solid : stage.solids)
        for (std::size_t k = 0; k < solid.sources.size(); ++k)
            if (surface_of_pressures(c, solid, k)) return pressure_range(c);
    return {};
}

/// For each source of a hull what pressure it has on it, or null.
Json pressures_json(const Comparison& c, const DrawnSolid& solid, const std::optional<PressureRange>& range) {
    Json all = Json::array();
    for (std::size_t k = 0; k < solid.sources.size(); ++k) {
        const Surface* recorded = range ? surface_of_pressures(c, solid, k) : nullptr;
        all.push_back(recorded ? Json(packed_pressures(c.sources[solid.sources[k]], *recorded, solid.surface, *range))
                               : Json());
    }
    return all;
}

/// Surfaces of hulls and bodies with their pressures, and of those that move one pose per surface of water of each
/// source.
Json solids_json(const Comparison& c, const Stage& stage, const View& view,
                 const std::optional<PressureRange>& pressure) {
    Json solids = Json::array();
    for (const DrawnSolid& solid : stage.solids) {
        SurfacePack pack(stage.box, solid_steps);
        pack.add(solid.surface);
        Json json = {
            {"sources", solid.sources}, {"surface", json_of(pack)}, {"pressures", pressures_json(c, solid, pressure)}};
        for (std::size_t k = 0; k < solid.sources.size() && solid.moves(); ++k) {
            const std::size_t s = solid.sources[k];
            Json poses = Json::array();
            for (const std::size_t frame : view.films[s].frame)
                poses.push_back(pose_json(body_pose(c.sources[s], *solid.motions[k], stage.frames[s][frame]->time)));
            json["poses"].push_back(poses);
        }
        solids.push_back(json);
    }
    return solids;
}

Json point_json(const Vec3& p) { return {p.x(), p.y(), p.z()}; }
Json box_json(const Box& box) { return {point_json(box.min), point_json(box.max)}; }

/// The block that the script reads.
std::string data_block(const Comparison& c, const Stage& stage, const View& view, const ColourScale& scale,
                       const std::optional<PressureRange>& pressure) {
    Json sources = Json::array();
    for (std::size_t s = 0; s < c.sources.size(); ++s) {
        Json times = Json::array();
        for (const std::size_t frame : view.films[s].frame) times.push_back(stage.frames[s][frame]->time);
        sources.push_back({{"name", method_label(c.names[s])},
                           {"mirror", is_mirrored(c.sources[s])},
                           {"time", times},
                           {"step", view.films[s].step},
                           {"water", view.films[s].water}});
    }
    const Json pressure_colours =
        pressure ? Json({{"stops", pressure_scale(pressure->low, pressure->high).stops()}}) : Json();
    const bool bodies = std::ranges::any_of(stage.solids, &DrawnSolid::is_body);
    const bool cut = bodies && std::ranges::any_of(c.sources, [](const RunRecord& r) { return r.raster.count[1] > 1; });
    const Json data = {{"box", box_json(stage.box)},
                       {"subject", box_json(subject_of(stage))},
                       {"ship", !stage.solids.empty() && !stage.solids.front().is_body()},
                       {"cut", cut ? Json((stage.path.min.y() + stage.path.max.y()) / 2) : Json()},
                       {"scale", {{"low", scale.low()}, {"high", scale.high()}, {"stops", scale.stops()}}},
                       {"pressure", pressure_colours},
                       {"time", view.times},
                       {"sources", sources},
                       {"hulls", solids_json(c, stage, view, pressure)}};
    return script_data("id=\"view3d-data\"", data);
}

/// Which frames are shown, and how finely.
std::string what_is_shown(const Comparison& c, const Stage& stage, const View& view) {
    std::string counts;
    bool all = true;
    for (std::size_t s = 0; s < c.sources.size(); ++s) {
        if (stage.frames[s].empty()) continue;
        const std::size_t shown = view.films[s].frame.size(), has = stage.frames[s].size();
        all = all && shown == has;
        counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", escaped(method_label(c.names[s])),
                              shown == has ? fmt::format("all {}", has) : fmt::format("{} of {}", shown, has));
    }
    std::string text = "Frames shown: " + counts + (all ? "." : ", evenly through the run, with the last one.");
    if (view.coarsening > 1)
        text += fmt::format(
            " To keep this page small the surface is drawn from blocks of {} voxels per edge, coarser than the raster "
            "that the numbers are taken from.",
            view.coarsening);
    return text;
}

constexpr const char* markup =
    R"(<p class="note" id="view3d-fallback">Here stands a view to turn and to play, drawn by a script with WebGL. This reader does not run it; the pictures above show the last frame.</p>
<div id="view3d-stage" hidden>
<div class="view3d-box"><canvas id="view3d-canvas" tabindex="0" role="application" aria-label="Free surface and hull in three dimensions. Arrow keys turn, with shift they move, plus and minus zoom, 0 resets the view, space plays."></canvas><div id="view3d-labels"></div></div>
<div class="view3d-bar"><button type="button" id="view3d-play">Play</button><input type="range" id="view3d-time" min="0" step="1" aria-label="time"><span class="view3d-clock" id="view3d-clock"></span></div>
<div class="view3d-bar"><span class="view3d-bar" id="view3d-toggles"></span>
<label>Colour <select id="view3d-colour"><option value="height">by height</option><option value="pressure">pressure on the hull</option><option value="method">one per method</option></select></label>
<label id="view3d-layout-label">Methods <select id="view3d-layout"><option value="beside">side by side</option><option value="over">in one picture</option></select></label>
<button type="button" id="view3d-reset">Reset view</button></div>
<p class="note">Turn: drag, or arrow keys. Move: drag with the right button, with shift or with two fingers, or shift and arrow keys. Zoom: wheel (after a click into the view), two fingers, or + and −. 0 resets the view, space plays.</p>
)";

/// What stands around the view; without pressures they are no choice.
std::string controls(bool pressures) {
    std::string text = markup;
    if (pressures) return text;
    const std::string_view choice = R"(<option value="pressure">pressure on the hull</option>)";
    return text.erase(text.find(choice), choice.size());
}

std::string pressure_legend(const PressureRange& range) {
    return "<div id=\"view3d-pressure\" hidden>" +
           pressure_scale(range.low / 1e3, range.high / 1e3).legend("pressure on the hull [kPa]") +
           "<p class=\"note\">Pressures are those of the last frame, at whatever time the water is shown; grey: dry or "
           "unknown. The hull is seen from below, through the water.</p></div>";
}

}  // namespace

std::string view3d_section(const Comparison& c) {
    const Stage stage = make_stage(c);
    if (stage.most_frames == 0) return {};
    std::size_t used = markup_bytes;
    for (const DrawnSolid& solid : stage.solids) {
        used += 4 * (solid.surface.points.size() + solid.surface.triangles.size());  // three bytes, as base64
        used += 2 * solid.sources.size() * solid.surface.triangles.size();           // pressures: one byte
        if (solid.moves()) used += solid.sources.size() * most_steps * pose_bytes;
    }
    const View view = fitting_view(c, stage, view3d_most_bytes - std::min(used, view3d_most_bytes / 2));
    const ColourScale scale = elevation_scale(elevation_half_range(c), c.analyses.front().still_level);
    const std::optional<PressureRange> pressure = shown_pressures(c, stage);
    const bool mirrored = std::ranges::any_of(c.sources, is_mirrored);
    return "<section class=\"view3d\"><h2>The water over time</h2><p class=\"note\">Surfaces where the water share of "
           "the common raster is one half, to turn and to play. " +
           what_is_shown(c, stage, view) + (mirrored ? " Half models are mirrored." : "") + "</p>\n" +
           controls(pressure.has_value()) + "<div id=\"view3d-legend\">" +
           scale.legend(is_stream(c.sources.front()) ? "height above still water [m]" : "height z [m]") + "</div>" +
           (pressure ? pressure_legend(*pressure) : "") + "</div>\n" + data_block(c, stage, view, scale, pressure) +
           "\n<script>" + view3d_script + "</script></section>";
}

}  // namespace tw

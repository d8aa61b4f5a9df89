#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "compare/compare.h"
#include "meshes/surface.h"

namespace tw {

/// The water of all sources over time and their hull, to be turned, played and laid over each other in the page: one
/// section of HTML with its data and its script (page/view3d.js), at most `view3d_most_bytes` long. Empty when no source
/// has raster frames that can be drawn. Without scripts or WebGL one sentence stands in its place; print leaves it out.
///
/// Each source shows up to 60 of its frames, evenly through the run and the last one always; where these are too much
/// for the page there are fewer, and below 24 the raster is averaged in blocks. The page says both. Names reach the
/// page as JSON text without markup characters.
std::string view3d_section(const Comparison& comparison);
inline constexpr std::size_t view3d_most_bytes = 1'450'000;  ///< so that a page has 2.5 MB at most

/// Style of the section, beside report_style.
inline constexpr const char* view3d_style = R"(
.view3d-box{position:relative;border:1px solid var(--line);border-radius:4px;overflow:hidden;background:var(--panel)}
.view3d-box canvas{display:block;width:100%;height:min(540px,75vh);touch-action:none;cursor:grab}
.view3d-box canvas:active{cursor:grabbing}.view3d-box canvas:focus-visible{outline:2px solid var(--s0);outline-offset:-2px}
.view3d-label{position:absolute;padding:6px 10px;font-size:13.5px;font-weight:600;pointer-events:none}
.view3d-bar{display:flex;flex-wrap:wrap;align-items:center;gap:6px 14px;margin:8px 0;font-size:14px}.view3d-bar button,.view3d-bar select{font:inherit;padding:2px 10px}
.view3d-bar input[type=range]{flex:1 1 200px}.view3d-clock{min-width:6.5em;font-variant-numeric:tabular-nums}
@media print{.view3d{display:none}}
)";

// Its surfaces (view3d_mesh.cpp).

/// A hull with at most `most` triangles and 65536 points: as it is where it has no more, else points in one cell of a
/// lattice become one. Triangles with a corner that is not finite are dropped.
Surface light_surface(const Surface& surface, std::size_t most);

/// Surfaces for the page's script, all of them in one deflated block (RFC 1950), so that what one has in common with the
/// one before is there once. Of each surface first x, then y, then z of its points, as numbers from 0 to `steps` over the
/// box's edges (error at most half a step); behind those of all surfaces the corners of the triangles of each, as point
/// numbers. Every such row of numbers is stored as differences from the number before, modulo 65536, signs in the lowest
/// bit (zigzag), and of these first all low and then all high bytes.
class SurfacePack {
public:
    SurfacePack(const Box& box, unsigned steps) : box_(box), steps_(steps) {}
    /// Throws std::length_error above 65536 points.
    void add(const Surface& surface);
    std::size_t size() const { return points_.size(); }
    const std::vector<std::size_t>& points() const { return points_; }        ///< of each surface
    const std::vector<std::size_t>& triangles() const { return triangles_; }  ///< of each surface
    unsigned steps() const { return steps_; }
    std::string block() const;  ///< in base64

private:
    Box box_;
    unsigned steps_;
    std::string places_, corners_;
    std::vector<std::size_t> points_, triangles_;
};

}  // namespace tw

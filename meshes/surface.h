#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec3.h"

namespace tw {

/// A triangulated surface [m]. Closed surfaces have outward normals (counter-clockwise seen from outside).
/// Points are shared between triangles: equal corners are one point.
struct Surface {
    std::vector<Vec3> points;                   ///< [m]
    std::vector<std::array<int, 3>> triangles;  ///< places of the corners among the points

    Vec3 corner(int triangle, int k) const {
        return points[static_cast<std::size_t>(
            triangles[static_cast<std::size_t>(triangle)][static_cast<std::size_t>(k)])];
    }
    /// Twice the area times the outward unit normal [m2].
    Vec3 area_vector2(int triangle) const {
        return (corner(triangle, 1) - corner(triangle, 0)).cross(corner(triangle, 2) - corner(triangle, 0));
    }
    Box bounds() const;
};

/// How a hull stands in the world. The file's axes are first turned so that x points to the stern and z up, then
/// scaled to metres; then heel about x, trim about y (bow up positive), then moved so that the lowest point lies
/// `draft` below still water (z = 0), and shifted by `position` in x and y.
struct Pose {
    double trim = 0;         ///< bow up [rad]
    double heel = 0;         ///< starboard down [rad]
    double draft = 0;        ///< depth of the lowest point below z = 0 [m]
    Vec3 position{0, 0, 0};  ///< x and y alone [m]
};
Surface posed(const Surface& surface, const Pose& pose);

/// The same surface with edges no longer than `max_edge` [m]: long edges are halved, in both their triangles alike,
/// until none is left; a closed surface stays closed. For quadrature over the surface. Throws InputError when that
/// would take more than `max_triangles`.
Surface refined(const Surface& surface, double max_edge, std::size_t max_triangles = 20'000'000);

/// Points closer than `tolerance` [m] become one (0: only equal points), triangles that lost a corner are dropped,
/// points no triangle uses are removed. The order of triangles and of first use is kept.
Surface welded(const Surface& surface, double tolerance = 0);

/// Metres per unit; throws InputError for an unknown name. Known: m, mm, cm, ft, in.
double metres_per(std::string_view unit);

/// Reads STL (ascii, binary), OBJ, PLY, VTP, STEP and IGES, each also compressed (.gz), merges equal corners, scales to
/// metres and applies `axes`: three signed axis letters saying which file axis becomes x, y, z: "xyz" as is, "x-zy" for
/// a file with y up, "-x-yz" for one whose bow points to +x. STEP and IGES name their own unit: `unit` stays "m". A
/// left-handed choice mirrors the hull; its triangles are then turned to keep normals outward. Polygons and drawings
/// (meshes/read/cad.h) are cut into triangles. Throws InputError naming the file: missing, empty, truncated, unreadable
/// or of unknown type, no triangles, non-finite coordinates, or an unknown unit or axis.
Surface read_surface(const std::filesystem::path& file, std::string_view unit = "m", std::string_view axes = "xyz");

/// Binary STL (single precision) written atomically; `name` goes into the 80-byte header only.
void write_stl(const std::filesystem::path& file, const Surface& surface, std::string_view name = "hull");

/// SHA-256 over the corner coordinates in triangle order: same surface, same hash.
std::string surface_hash(const Surface& surface);

}  // namespace tw

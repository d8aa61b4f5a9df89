#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec3.h"
#include "meshes/query.h"

namespace tw {

/// The surfaces that bound water at the start beside the faces of its blocks.
struct WaterBounds {
    int dimensions = 3;
    Box domain;
    std::array<std::array<bool, 2>, 3> walls{};  ///< faces of the domain that hold the water: [axis][low, high]
    std::span<const SurfaceQuery> solids;
    /// A wall or a solid nearer than this to a face of the water holds it: no particle goes between [m].
    double clear = 0;  ///< [m]
};

/// The cells of a group of boxes of water that touch (base/disjoint_boxes.h), between planes of which some lie on all
/// faces of the boxes, so that each cell is full or empty. A cell whose middle is in a solid is empty.
class WaterGrid {
public:
    /// Cells of about `spacing` [m], of a multiple of that where they were more than `most`.
    WaterGrid(std::span<const Box> boxes, const WaterBounds& bounds, double spacing, double most);

    enum class Face : std::uint8_t { open, wall, free };

    struct Cell {
        std::array<std::int32_t, 3> at;                     ///< between which planes
        std::int32_t part;                                  ///< of the connected parts
        std::array<std::array<std::int32_t, 2>, 3> beside;  ///< [axis][low, high] the cell there; -1: none
        std::array<std::array<Face, 2>, 3> face;
    };
    const std::vector<Cell>& cells() const { return cells_; }
    Vec3 middle(const Cell& c) const;
    Vec3 size(const Cell& c) const;                      ///< in two dimensions 1 along y
    Vec3 face(const Cell& c, int axis, int side) const;  ///< its middle

    /// Water that is connected.
    struct Part {
        double level = 0;      ///< z of its highest free surface, or of its top where it has none [m]
        double lowest = 0;     ///< z of its lowest surface that looks up [m]
        bool is_free = false;  ///< it has a free surface
        bool let_go = false;   ///< of which a part looks down or to a side
        bool at_rest() const { return !let_go && lowest == level; }  ///< under hydrostatic pressure it stays as it is
        std::int32_t cells = 0;
        Box bounds;
    };
    const std::vector<Part>& parts() const { return parts_; }

    /// The cell whose water a place belongs to: around it or, where that is empty or beyond a solid, the nearest beside
    /// it; -1: none.
    std::int32_t cell_near(const Vec3& place) const;

private:
    void divide(std::span<const Box> boxes, double spacing, double most);
    void fill(std::span<const Box> boxes);
    void find_faces();
    void connect();
    std::size_t index(const std::array<std::int32_t, 3>& at) const;
    bool solid_between(const Vec3& a, const Vec3& b, double distance) const;

    WaterBounds bounds_;
    std::array<std::vector<double>, 3> planes_;
    std::vector<Cell> cells_;
    std::vector<double> to_solid_;  ///< of each cell's middle, up to `reach_` [m]
    double reach_ = 0;
    static constexpr std::int32_t no_water = -1, in_solid = -2;
    std::vector<std::int32_t> cell_;  ///< at each place between the planes, or one of these
    std::vector<Part> parts_;
};

}  // namespace tw

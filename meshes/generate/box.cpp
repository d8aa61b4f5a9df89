#include "meshes/generate/shapes.h"

namespace tw {
namespace {
Surface make_box(const std::map<std::string, double>& v) { return block(v.at("length"), v.at("beam"), v.at("height")); }
}  // namespace

HullShape box_shape() {
    return {"box",
            "rectangular block",
            {{"length", "m", "along x", 1, 1e-4, 500},
             {"beam", "m", "along y", 1, 1e-4, 500},
             {"height", "m", "along z", 1, 1e-4, 500}},
            make_box};
}

Surface box_surface(const Box& box) {
    Surface surface;
    for (int corner = 0; corner < 8; ++corner)
        surface.points.push_back({(corner & 1 ? box.max : box.min).x(), (corner & 2 ? box.max : box.min).y(),
                                  (corner & 4 ? box.max : box.min).z()});
    surface.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                         {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return surface;
}

}  // namespace tw

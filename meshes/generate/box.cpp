#include "meshes/generate/shapes.h"

namespace tw {
namespace {
Surface make(const std::map<std::string, double>& v) { return block(v.at("length"), v.at("beam"), v.at("height")); }
}  // namespace

HullShape box_shape() {
    return {"box",
            "rectangular block",
            {{"length", "m", "along x", 1, 1e-4, 500},
             {"beam", "m", "along y", 1, 1e-4, 500},
             {"height", "m", "along z", 1, 1e-4, 500}},
            make};
}

}  // namespace tw

#include "meshes/generate/shapes.h"

namespace tw {
namespace {
Surface make_plate(const std::map<std::string, double>& v) {
    return block(v.at("length"), v.at("beam"), v.at("thickness"));
}
}  // namespace

HullShape plate_shape() {
    return {"plate",
            "flat plate with sharp edges, as used for flat-plate planing",
            {{"length", "m", "along x", 4, 1e-4, 500},
             {"beam", "m", "along y", 1, 1e-4, 500},
             {"thickness", "m", "along z", 0.3, 1e-4, 100}},
            make_plate};
}

}  // namespace tw

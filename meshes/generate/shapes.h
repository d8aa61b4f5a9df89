#pragma once
#include "base/numbers.h"
#include "meshes/generate.h"

namespace tw {

// One file per shape. Each returns its description with defaults and ranges; `make` gets every parameter.
HullShape prismatic_shape();
HullShape fridsma_shape();
HullShape seaplane_shape();
HullShape wigley_shape();
HullShape wedge_shape();
HullShape plate_shape();
HullShape box_shape();
HullShape cylinder_shape();
HullShape sphere_shape();
HullShape torpedo_shape();

/// A rectangular block, its bottom at z = 0, centred in x and y.
Surface block(double length, double beam, double height);

}  // namespace tw

#include "spray/air/air.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"

namespace tw::spray {

void check_air(const AirState& state) {
    if (!state.velocity.allFinite()) throw InputError("air: its velocity is not finite");
    if (!(state.density > 0) || !std::isfinite(state.density))
        throw InputError(fmt::format("air: a density of {:g} kg/m3; expected above 0", state.density));
    if (!(state.viscosity > 0) || !std::isfinite(state.viscosity))
        throw InputError(fmt::format("air: a viscosity of {:g} Pa s; expected above 0", state.viscosity));
}

AirTable::AirTable(std::vector<Row> rows) : rows_(std::move(rows)) {
    if (rows_.size() < 2) throw InputError("air table: fewer than two heights; expected two or more");
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        check_air(rows_[i].state);
        if (!std::isfinite(rows_[i].z) || (i > 0 && !(rows_[i].z > rows_[i - 1].z)))
            throw InputError(
                fmt::format("air table: height {:g} m in row {}; expected increasing heights", rows_[i].z, i + 1));
    }
}

bool AirTable::at(const Vec3& place, AirState& state) const {
    const double z = place.z();
    if (!(z >= rows_.front().z && z <= rows_.back().z)) return false;
    const auto above = std::upper_bound(rows_.begin() + 1, rows_.end() - 1, z,
                                        [](double height, const Row& row) { return height < row.z; });
    const Row &low = *(above - 1), &high = *above;
    const double s = (z - low.z) / (high.z - low.z);
    state.velocity = (1 - s) * low.state.velocity + s * high.state.velocity;
    state.density = (1 - s) * low.state.density + s * high.state.density;
    state.viscosity = (1 - s) * low.state.viscosity + s * high.state.viscosity;
    return true;
}

}  // namespace tw::spray

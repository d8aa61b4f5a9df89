#include "foam_cases/read/step_loads.h"

#include <algorithm>

#include "foam_cases/read/number_rows.h"

namespace tw {

StepLoads read_loads(const std::filesystem::path& folder) {
    using Rows = std::vector<std::vector<double>>;
    StepLoads out;
    const Rows force = joined_rows(folder, "force.dat"), moment = joined_rows(folder, "moment.dat");
    for (auto at = moment.begin(); const auto& f : force) {
        at = std::find_if(at, moment.end(), [&](const auto& row) { return row[0] >= f[0]; });
        if (at == moment.end()) break;
        const auto& m = *at;
        if (f.size() < 10 || m.size() < 10 || f[0] != m[0]) continue;
        out.time.push_back(f[0]);
        out.pressure.push_back({f[4], f[5], f[6], m[4], m[5], m[6]});
        out.viscous.push_back({f[7], f[8], f[9], m[7], m[8], m[9]});
    }
    if (!out.time.empty()) return out;
    for (const auto& r : joined_rows(folder, "forces.dat")) {
        const std::size_t half = (r.size() - 1) / 2;
        if (half < 6) continue;
        out.time.push_back(r[0]);
        out.pressure.push_back({r[1], r[2], r[3], r[1 + half], r[2 + half], r[3 + half]});
        out.viscous.push_back({r[4], r[5], r[6], r[4 + half], r[5 + half], r[6 + half]});
    }
    return out;
}

}  // namespace tw

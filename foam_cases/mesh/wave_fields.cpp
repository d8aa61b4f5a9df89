#include "foam_cases/mesh/wave_fields.h"

#include <algorithm>
#include <cmath>

#include "base/atomic_file.h"
#include "foam_cases/files/case_files.h"
#include "foam_cases/read/field_file.h"
#include "foam_cases/read/time_folders.h"
#include "scene/box/tank_wave.h"

namespace tw {

void begin_with_wave(const CasePlan& plan, const std::filesystem::path& time_folder) {
    const TankWave wave(*plan.scene);
    const FieldFile centres = read_field(time_folder / "C"),
                    volumes = read_field(time_folder / cell_volumes_in(time_folder));
    const bool flat = plan.scene->domain.dimensions == 2;
    const double across = plan.scene->domain.box.size().y();
    constexpr int columns = 8;  // of a cell, in which the surface is level
    std::vector<double> water;
    std::vector<Vec3> velocity;
    for (std::size_t i = 0; i < centres.cells(); ++i) {
        const Vec3 at = centres.vector(i);
        const double edge = flat ? std::sqrt(volumes.scalar(i) / across) : std::cbrt(volumes.scalar(i));
        double share = 0;
        for (int k = 0; k < columns; ++k) {
            const double surface = wave.surface(at.x() + ((k + 0.5) / columns - 0.5) * edge);
            share += std::clamp((surface - at.z()) / edge + 0.5, 0.0, 1.0) / columns;
        }
        water.push_back(share);
        velocity.push_back(wave.velocity(at.x(), std::min(at.z(), wave.surface(at.x()))));
    }
    write_text_atomically(time_folder / "alpha.water", alpha_water(plan, Value::nonuniform(water)));
    write_text_atomically(time_folder / "U", velocity_field(plan, Value::nonuniform(velocity)));
}

}  // namespace tw

#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sph_solver/backend/pass_data.h"

namespace tw {

/// What the sweeps over the pairs read and write of the particles of one level; some continue with its mirror images.
struct Records {
    std::vector<PlaceRecord> place;                         ///< and images
    std::vector<VelocityDensityRecord> velocity_density;    ///< and images
    std::vector<GradientPressureRecord> gradient_pressure;  ///< and images
    std::vector<ShiftSupportRecord> shift_support;
    std::vector<RateRecord> rate;
    std::vector<WallNormalRecord> wall_normal;  ///< only where there are walls
    std::vector<LeavingRecord> wall_leaving;    ///< off its edges; only where there are walls
    std::vector<std::uint16_t> wall_body;       ///< whose normal that is; only where bodies move
    std::vector<std::int32_t> wall_triangle;    ///< and on which triangle of it; only where bodies are elastic
    std::vector<CarriedShare> carried;          ///< and images; only with a control volume
    std::vector<std::uint32_t> surface;         ///< a bit for each place, see PassData
    std::vector<float> compression;             ///< -rho div u of the last first sweep; only where levels meet

    /// For `n` particles and `images` images of them; new entries are not initialised to anything meaningful.
    void resize(std::size_t n, std::size_t images, bool walls, bool carry) {
        place.resize(n + images);
        velocity_density.resize(n + images);
        gradient_pressure.resize(n + images);
        shift_support.resize(n);
        rate.resize(n);
        surface.assign((n + images) / 32 + 2, 0);
        if (walls) wall_normal.resize(n), wall_leaving.resize(n);
        if (carry) carried.resize(n + images);
    }
    std::size_t bytes() const {
        const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
        return of(place) + of(velocity_density) + of(gradient_pressure) + of(shift_support) + of(rate) +
               of(wall_normal) + of(wall_leaving) + of(carried) + of(surface);
    }
};

}  // namespace tw

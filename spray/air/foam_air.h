#pragma once
#include <filesystem>
#include <memory>
#include <optional>

#include "spray/air/air.h"

namespace tw::spray {

/// The velocity U of one time of an OpenFOAM case as steady air; its density and viscosity are given. The values of the
/// cells are carried to their corners and are linear between those, so the air is continuous. Of an interFoam case the
/// water's U is air as well: droplets below the water level have landed.
class FoamAir : public Air {
public:
    /// `run`: RUN/fvm, or a case. `time`: one that is written, or nothing for the last. Throws InputError naming the
    /// case: no such time (with those that are there), no field U, values that are not finite.
    FoamAir(const std::filesystem::path& run, std::optional<double> time, const AirState& state);
    ~FoamAir() override;
    /// Covered inside the mesh.
    bool at(const Vec3& place, AirState& state) const override;

private:
    struct Field;
    AirState state_;
    std::unique_ptr<const Field> field_;
};

}  // namespace tw::spray

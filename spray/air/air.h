#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "base/vec3.h"

namespace tw::spray {

/// Air at one place.
struct AirState {
    Vec3 velocity = Vec3::Zero();  ///< [m/s]
    double density = 1.225;        ///< [kg/m3]; standard atmosphere at sea level
    double viscosity = 1.81e-5;    ///< dynamic [Pa s]; 15 to 20 degrees
};

/// Steady air. Thread-safe.
class Air {
public:
    virtual ~Air() = default;
    /// False outside what the field covers; `state` is then left alone.
    virtual bool at(const Vec3& place, AirState& state) const = 0;
};

/// The same everywhere.
class UniformAir : public Air {
public:
    explicit UniformAir(const AirState& state) : state_(state) {}
    bool at(const Vec3&, AirState& state) const override {
        state = state_;
        return true;
    }

private:
    AirState state_;
};

/// A table over the height z, linear between its rows: wind profiles, ground effect.
class AirTable : public Air {
public:
    struct Row {
        double z;  ///< [m], increasing
        AirState state;
    };
    /// Throws InputError: fewer than two rows, heights that do not increase, values that are not finite or not above 0.
    explicit AirTable(std::vector<Row> rows);
    /// Covered between the first and the last height.
    bool at(const Vec3& place, AirState& state) const override;

private:
    std::vector<Row> rows_;
};

/// Throws InputError naming what cannot be: density or viscosity not above 0, anything that is not finite.
void check_air(const AirState& state);

}  // namespace tw::spray

#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec3.h"
#include "sph_solver/loops/wall_motion.h"

namespace tw {

/// Points that go with a body, and how its surface moves by them. This one is of a body that is fixed.
class Attached {
public:
    explicit Attached(std::vector<Vec3> at_start) : at_start_(std::move(at_start)) {}
    virtual ~Attached() = default;
    Attached(const Attached&) = delete;
    Attached& operator=(const Attached&) = delete;

    virtual std::size_t size() const { return at_start_.size(); }
    /// Looks at how the body moves now, for the velocities of a rigid one.
    virtual void look() {}
    virtual Vec3 place(std::size_t k) const { return at_start_[k]; }  ///< now [m]
    struct Motion {
        Vec3 velocity = Vec3::Zero(), acceleration = Vec3::Zero();  ///< [m/s], [m/s2]
    };
    /// Of point k, which is at `place`.
    virtual Motion motion(std::size_t /*k*/, const Vec3& /*place*/) const { return {}; }
    /// Velocity of the body's surface by `x`, on or near one of its triangles (-1: none) [m/s].
    virtual Vec3 surface_velocity(const Vec3& /*x*/, std::int32_t /*triangle*/) const { return Vec3::Zero(); }
    /// The same of a rigid body everywhere.
    virtual WallMotion surface_motion() const { return {}; }
    /// What says it of a body that deforms; empty: it does not.
    struct WettedSurface {
        std::span<const Corners> corners;
        std::span<const V3<double>> noted, velocity;  ///< as SurfaceMotion has them [m], [m/s]
        std::int64_t times_noted = 0;
    };
    virtual WettedSurface wetted_surface() const { return {}; }
    /// The largest speed of a point or of the surface [m/s].
    virtual double fastest() const { return 0; }
    /// The k-th is then what order[k] is now.
    virtual void reorder(const std::vector<std::int32_t>& order) { at_start_ = reordered(at_start_, order); }
    virtual std::size_t bytes() const { return at_start_.capacity() * sizeof(Vec3); }

    const std::vector<Vec3>& at_start() const { return at_start_; }  ///< empty of a body that deforms

protected:
    template <class T>
    static std::vector<T> reordered(const std::vector<T>& all, const std::vector<std::int32_t>& order) {
        std::vector<T> sorted;
        sorted.reserve(order.size());
        for (const std::int32_t k : order) sorted.push_back(all[static_cast<std::size_t>(k)]);
        return sorted;
    }

private:
    std::vector<Vec3> at_start_;
};

}  // namespace tw

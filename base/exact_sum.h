#pragma once
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/vec3.h"

namespace tw {

/// A sum of doubles that does not depend on the order in which its parts are added, nor on how they are shared among
/// threads or machines: whole numbers of 128 bits are added. Fixed point, as in the long accumulators of Kulisch
/// (Computer Arithmetic and Validity, 2nd ed. 2013, doi:10.1515/9783110301793), but short:
///
/// - Every addend is cut to a whole multiple of 2^-63 (1.1e-19) towards zero. What it has below that is lost, and an
///   addend smaller than that is lost altogether; from 5e-4 on (2^-11) nothing is lost. So what is added should not be
///   tiny by its unit: sum velocities, accelerations and their squares, and multiply by the particles' mass at the end.
/// - The sum has to fit at the end, not on the way: |sum| < 2^64 = 1.8e19.
/// - An addend that is not finite, or of 2^62 = 4.6e18 and more, makes the sum not a number.
class ExactSum {
public:
    ExactSum& operator+=(double addend) {
        if (std::abs(addend) < 0x1p62) {
            const auto whole = static_cast<std::int64_t>(addend);
            const auto rest = static_cast<std::int64_t>((addend - static_cast<double>(whole)) * per_one);
            units_ += (static_cast<Units>(static_cast<Signed>(whole)) << 63) + static_cast<Units>(Signed{rest});
        } else {
            broken_ = true;
        }
        return *this;
    }
    ExactSum& operator+=(const ExactSum& other) {
        units_ += other.units_;
        broken_ |= other.broken_;
        return *this;
    }
    /// The nearest double.
    double value() const {
        if (broken_) return std::numeric_limits<double>::quiet_NaN();
        return static_cast<double>(static_cast<Signed>(units_)) / per_one;
    }

private:
    __extension__ typedef __int128 Signed;
    __extension__ typedef unsigned __int128 Units;  // wraps round, so that only the end has to fit
    static constexpr double per_one = 0x1p63;

    Units units_ = 0;
    bool broken_ = false;
};

/// The same of each component of a vector.
class ExactVectorSum {
public:
    ExactVectorSum& operator+=(const Vec3& addend) {
        x_ += addend.x(), y_ += addend.y(), z_ += addend.z();
        return *this;
    }
    ExactVectorSum& operator+=(const ExactVectorSum& other) {
        x_ += other.x_, y_ += other.y_, z_ += other.z_;
        return *this;
    }
    Vec3 value() const { return {x_.value(), y_.value(), z_.value()}; }

private:
    ExactSum x_, y_, z_;
};

}  // namespace tw

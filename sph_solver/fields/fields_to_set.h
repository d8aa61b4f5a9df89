#pragma once
#include <cstddef>

#include "sph_solver/fields/particles.h"

namespace tw {

/// A quantity of all particles whose values may be set: not how many they are, and not in which order.
template <class T>
class ValuesToSet {
public:
    explicit ValuesToSet(std::vector<T>& of) : of_(&of) {}
    T& operator[](std::size_t i) const { return (*of_)[i]; }
    T* begin() const { return of_->data(); }
    T* end() const { return of_->data() + of_->size(); }
    std::size_t size() const { return of_->size(); }

private:
    std::vector<T>* of_;  ///< a vector that may grow
};

/// The state of a level's particles, to be set from outside the engine, with who they are.
struct FieldsToSet {
    ValuesToSet<double> x, y, z;       ///< [m]
    ValuesToSet<float> u, v, w, drho;  ///< [m/s], [kg/m3]
    const FieldOf<std::int64_t>& id;
    const FieldOf<Kind>& kind;

    explicit FieldsToSet(Particles& p)
        : x(p.x), y(p.y), z(p.z), u(p.u), v(p.v), w(p.w), drho(p.drho), id(p.id), kind(p.kind) {}
    std::size_t size() const { return x.size(); }
};

}  // namespace tw

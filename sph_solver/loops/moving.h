#pragma once
#include <cstddef>
#include <cstdint>

#include "sph_solver/domain/kind.h"
#include "sph_solver/fields/quantities.h"
#include "sph_solver/loops/records.h"

namespace tw {

/// All that stays with a particle when particles are sorted, come and go (those of Particles that move), each as an `As`
/// of its type: arrays on a device, pointers for its kernels. A quantity is one line here and its name once more in one of
/// the two lists below.
template <template <class> class As>
struct Moving {
    As<double> x, y, z;
    As<float> u, v, w, drho;
    As<std::int64_t> id;
    As<Kind> kind;
    // what a level may lack
    As<Aired> aired;
    As<Trend> trend;
    As<EdgeDistance> from_edge;
    As<Children> children;
    As<float> compression;
    As<EdgeDistance> from_finer_edge;

    /// Calls `f(field, other)` for each quantity that every level has, and what `others` calls by the same name.
    template <class Self, class Others, class Function>
    static void each_kept(Self& self, Others& others, const Function& f) {
        f(self.x, others.x), f(self.y, others.y), f(self.z, others.z);
        f(self.u, others.u), f(self.v, others.v), f(self.w, others.w), f(self.drho, others.drho);
        f(self.id, others.id), f(self.kind, others.kind);
    }
    /// The same for what a level may lack.
    template <class Self, class Others, class Function>
    static void each_possible(Self& self, Others& others, const Function& f) {
        f(self.aired, others.aired), f(self.trend, others.trend), f(self.from_edge, others.from_edge);
        f(self.children, others.children), f(self.compression, others.compression);
        f(self.from_finer_edge, others.from_finer_edge);
    }
    template <class Self, class Others, class Function>
    static void each(Self& self, Others& others, const Function& f) {
        each_kept(self, others, f), each_possible(self, others, f);
    }
};

template <class T>
using PointerTo = T*;

/// For kernels; null: the level's particles have none.
struct MovingView : Moving<PointerTo> {
    /// Particle i becomes what particle k of another view of the same level is.
    void copy(std::size_t i, const MovingView& from, std::size_t k) const {
        each_kept(*this, from, [i, k](auto* to, const auto* of) { to[i] = of[k]; });
        each_possible(*this, from, [i, k](auto* to, const auto* of) {
            if (to) to[i] = of[k];
        });
    }
    /// Beside its state it has what new ones have.
    void begin(std::size_t i) const {
        each_possible(*this, *this, [i](auto* field, const auto*) {
            if (field) field[i] = {};
        });
    }
};

}  // namespace tw

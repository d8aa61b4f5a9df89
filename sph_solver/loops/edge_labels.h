#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "sph_solver/domain/kind.h"
#include "sph_solver/equations/vector.h"
#include "sph_solver/fields/quantities.h"
#include "sph_solver/pair_loops/packed.h"

namespace tw {

/// Whether a particle's distance from the edge of a zone has to be worked out again: only where one of the two may have
/// come past a limit since it was. So what is known compares with every limit as the true distance does. It is kept to
/// 2^-24 of itself.
struct AskEdge {
    static constexpr int most_limits = 5;
    double limits[most_limits];  ///< [m]; infinite where there are fewer
    double steepest;             ///< of Zone [-]
    double by, turn;             ///< how far the edge has come, sums of Zone::Shift since the start [m], [rad]
    V3<double> pivot;            ///< of the zone [m]

    bool knows(const V3<double>& x, const EdgeDistance& known) const {
        constexpr double rounding = 2e-7;
        const double outside = static_cast<double>(known.outside);
        double gap = std::numeric_limits<double>::infinity();
        for (const double limit : limits) {
            const double off = magnitude(outside - limit);
            gap = off < gap ? off : gap;
        }
        const V3<double> from{known.x, known.y, known.z};
        double change = steepest * (length(x - from) + rounding * (magnitude(x.x) + magnitude(x.y) + magnitude(x.z))) +
                        rounding * magnitude(outside);
        if (by > 0 || turn > 0) {
            const double turned = turn - static_cast<double>(known.turn) + rounding * turn;
            // The place came by the shift as well while its distance from the pivot was another.
            change += (by - static_cast<double>(known.by) + rounding * by + turned * length(x - pivot)) / (1 - turned);
            if (turned >= 1) return false;
        }
        return change < gap;
    }
    EdgeDistance found(const V3<double>& x, double outside) const {
        return {static_cast<float>(x.x),     static_cast<float>(x.y), static_cast<float>(x.z),
                static_cast<float>(outside), static_cast<float>(by),  static_cast<float>(turn)};
    }

private:
    static double magnitude(double x) { return x < 0 ? -x : x; }
    static double length(const V3<double>& x) { return std::sqrt(dot(x, x)); }
};

/// What a coarse particle is by its distance from the edge of a finer level's zone, see Refinement.
struct LabelCoarse {
    Kind* kind = nullptr;
    Daughters* daughters = nullptr;
    double overlap = 0, again = 0, barren = 0;  ///< [m]

    void operator()(std::size_t i, double outside) const {
        const bool under = stands_for_finer(kind[i]);
        if (outside < 0 && (under || kind[i] == Kind::fluid))
            kind[i] = outside > -overlap ? Kind::overlap : Kind::slave;
        else if (outside >= 0 && under)
            kind[i] = Kind::fluid;
        if (outside > barren)
            daughters[i] = Daughters::none;
        else if (outside > again && daughters[i] == Daughters::all)
            daughters[i] = Daughters::some;
    }
};

/// What a particle is by its distance from the edge of its own level's zone, see Refinement.
struct LabelFine {
    Kind* kind = nullptr;
    double gone_beyond = 0;  ///< [m]
    int* leaves = nullptr;   ///< whether it is water outside the zone
    int* gone = nullptr;     ///< whether it is a buffer particle that nobody needs

    void operator()(std::size_t i, double outside) const {
        if (kind[i] == Kind::buffer && outside < 0) kind[i] = Kind::fluid;
        leaves[i] = kind[i] == Kind::fluid && outside >= 0;
        gone[i] = kind[i] == Kind::buffer && outside > gone_beyond;
    }
};

/// A coarse particle that is to have daughters.
struct Parent {
    std::int64_t index;
    V3<double> place;  ///< [m]
    PackedVelocityDensity state;
    Daughters before;

    static bool is(Kind kind, Daughters daughters, double outside, double within) {
        return (kind == Kind::fluid || stands_for_finer(kind)) && daughters != Daughters::all && outside < within;
    }
};
struct Child {
    V3<double> place;  ///< [m]
    PackedVelocityDensity state;
    Kind kind;
    std::int64_t id;
};
struct Located {
    std::int64_t index;
    V3<double> place;  ///< [m]
};

}  // namespace tw

#pragma once
// What is done where two levels of particle size meet: plain data for kernels, as in tasks.h.
#include "sph_solver/device/launch.h"
#include "sph_solver/loops/at_edge.h"
#include "sph_solver/loops/edge_labels.h"
#include "sph_solver/neighbours/wide_place.h"

namespace tw::cuda {

/// Particles that follow another level: its guards, or what stands for a finer level's water.
struct MarkFollowing {
    const Kind* kind;
    bool guards;
    int* follows;

    void operator()(std::size_t i) const { follows[i] = guards ? kind[i] == Kind::guard : stands_for_finer(kind[i]); }
};
/// What is marked, one after another.
struct ListMarked {
    const int *marked, *before;
    int* which;

    void operator()(std::size_t i) const {
        if (marked[i]) which[before[i]] = static_cast<int>(i);
    }
};
/// Where they are asked for, as the other level sees places.
struct GuardsAhead {
    FollowCoarser follow;
    ToQuanta to_quanta;
    const int* which;
    WidePlace* wide;

    void operator()(std::size_t k) const {
        const V3<double> x = follow.place_ahead(static_cast<std::size_t>(which[k]));
        wide[k] = to_quanta.wide(x.x, x.y, x.z);
    }
};
struct UnderZone {
    StateView p;
    ToQuanta to_quanta;
    const int* which;
    WidePlace* wide;

    void operator()(std::size_t k) const {
        const auto i = static_cast<std::size_t>(which[k]);
        wide[k] = to_quanta.wide(p.x[i], p.y[i], p.z[i]);
    }
};
/// The squares of their speeds.
struct FastestOf {
    StateView p;
    const int* which;

    double operator()(std::size_t k) const { return speed2(p, static_cast<std::size_t>(which[k])); }
};

// --- who is what

/// Labels those whose distance from the edge is known, and puts the others on a list, in no order.
struct LabelKnown {
    AskEdge ask;
    LabelCoarse label;
    StateView p;
    EdgeDistance* known;
    int *unknown, *count;

    V3<double> place(std::size_t i) const { return {p.x[i], p.y[i], p.z[i]}; }
    template <class AddOne>
    void operator()(std::size_t i, const AddOne& add_one) const {
        if (ask.knows(place(i), known[i]))
            label(i, static_cast<double>(known[i].outside));
        else
            unknown[add_one(count)] = static_cast<int>(i);
    }
};
struct TakePlaces {
    StateView p;
    const int* which;
    V3<double>* to;

    void operator()(std::size_t k) const {
        const auto i = static_cast<std::size_t>(which[k]);
        to[k] = {p.x[i], p.y[i], p.z[i]};
    }
};
/// Labels those of the list, of whom the host has worked it out.
struct LabelAsked {
    LabelKnown of;
    const double* outside;  ///< [m]

    void operator()(std::size_t k) const {
        const auto i = static_cast<std::size_t>(of.unknown[k]);
        of.known[i] = of.ask.found(of.place(i), outside[k]);
        of.label(i, outside[k]);
    }
};
struct ForgetEdge {
    EdgeDistance* known;

    void operator()(std::size_t i) const { known[i] = {}; }
};

// --- who gives

struct MarkGiving {
    TakeGiving take;
    int* gives;

    void operator()(std::size_t i) const { gives[i] = take.counts(i); }
};
struct PutGiving {
    TakeGiving take;
    const int *gives, *before;

    void operator()(std::size_t i) const {
        if (gives[i]) take.put(i, static_cast<std::size_t>(before[i]));
    }
};
/// The first of each column among those that give.
struct StartGiving {
    const int* start;  ///< of all particles, or all images
    int stride;
    std::size_t from;  ///< index of the first of them
    const int* before;
    int* to;

    void operator()(std::size_t c) const {
        to[c] = before[from + static_cast<std::size_t>(start[c * static_cast<std::size_t>(stride)])];
    }
};

// --- places

struct SortAsked {
    const int* order;
    const WidePlace* wide;
    PlaceRecord* place;

    void operator()(std::size_t k) const { place[k] = wide[order[k]].record(0); }
};
/// What a sweep has found at sorted places.
struct FoundAt {
    const int* order;  ///< which place stands at k
    const VelocityDensityRecord* value;
    const float *support, *mean_support;
    const float* compression;  ///< null: it was not asked for

    Given operator()(std::size_t k) const {
        return {value[k], support[k], mean_support[k], compression ? compression[k] : 0};
    }
};
/// Lets the k-th of sorted places' particles follow what was found there, and marks those that nobody has water for.
template <class Follow>
struct Hand {
    Follow follow;
    FoundAt found;
    const int* which;
    int* orphan;

    void operator()(std::size_t k) const {
        const Given given = found(k);
        orphan[k] = !given.known();
        follow(static_cast<std::size_t>(which[found.order[k]]), given);
    }
};
using HandToGuards = Hand<FollowCoarser>;
using HandToUnder = Hand<FollowFiner>;
/// The same for places of the host, in their order.
struct HandToHost {
    FoundAt found;
    Given* to;

    void operator()(std::size_t k) const { to[found.order[k]] = found(k); }
};

}  // namespace tw::cuda

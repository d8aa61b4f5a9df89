#pragma once
// What is done where two levels of particle size meet: plain data for kernels, as in tasks.h.
#include "sph_solver/device/launch.h"
#include "sph_solver/fields/field_list.h"
#include "sph_solver/loops/at_edge.h"
#include "sph_solver/loops/edge_labels.h"
#include "sph_solver/neighbours/wide_place.h"

namespace tw::cuda {

/// Particles that follow another level: its buffer particles, or what stands for a finer level's water.
struct MarkFollowing {
    const Kind* kind;
    bool buffers;
    int* follows;

    void operator()(std::size_t i) const { follows[i] = buffers ? kind[i] == Kind::buffer : stands_for_finer(kind[i]); }
};
/// What is marked, one after another.
struct ListMarked {
    const int *marked, *before;
    int* which;

    void operator()(std::size_t i) const {
        if (marked[i]) which[before[i]] = static_cast<int>(i);
    }
};
/// Where they are, or will be after a time, as the other level sees places.
struct PlacesToAsk {
    StateView p;
    double ahead;  ///< [s]
    ToFixedPoint to_fixed_point;
    const int* which;
    WidePlace* wide;

    void operator()(std::size_t k) const {
        const V3<double> x = place_ahead(p, static_cast<std::size_t>(which[k]), ahead);
        wide[k] = to_fixed_point.wide(x.x, x.y, x.z);
    }
};
/// The same for a level that several ranks share.
struct PlacesAhead {
    StateView p;
    double ahead;  ///< [s]
    const int* which;
    V3<double>* place;  ///< [m]

    void operator()(std::size_t k) const { place[k] = place_ahead(p, static_cast<std::size_t>(which[k]), ahead); }
};
/// The squares of their speeds.
struct FastestOf {
    StateView p;
    const int* which;

    double operator()(std::size_t k) const { return speed2(p, static_cast<std::size_t>(which[k])); }
};

/// What a pair loop has found at sorted places.
struct FoundAt {
    const int* order;  ///< which place stands at k
    const PackedVelocityDensity* value;
    const float *support, *mean_support;  ///< [-]
    const float* compression;             ///< null: it was not asked for [kg/m3/s]

    Given operator()(std::size_t k) const {
        return {value[k], support[k], mean_support[k], compression ? compression[k] : 0};
    }
};
// --- who is what

/// Labels those whose distance from the edge is known, and puts the others on a list, in no order.
template <class Label>
struct LabelKnown {
    AskEdge ask;
    Label label;
    StateView p;
    EdgeDistance* known;
    double* outside;  ///< Zone::outside of each particle [m]
    int *unknown, *count;

    V3<double> place(std::size_t i) const { return {p.x[i], p.y[i], p.z[i]}; }
    void is(std::size_t i, double at) const {
        outside[i] = at;
        label(i, at);
    }
    template <class AddOne>
    void operator()(std::size_t i, const AddOne& add_one) const {
        if (ask.knows(place(i), known[i]))
            is(i, static_cast<double>(known[i].outside));
        else
            unknown[add_one(count)] = static_cast<int>(i);
    }
};
using LabelCoarseKnown = LabelKnown<LabelCoarse>;
using LabelFineKnown = LabelKnown<LabelFine>;
/// Labels those of the list, of whom the host has worked it out.
template <class Label>
struct LabelAsked {
    LabelKnown<Label> of;
    const double* outside;  ///< [m]

    void operator()(std::size_t k) const {
        const auto i = static_cast<std::size_t>(of.unknown[k]);
        of.known[i] = of.ask.found(of.place(i), outside[k]);
        of.is(i, outside[k]);
    }
};
using LabelCoarseAsked = LabelAsked<LabelCoarse>;
using LabelFineAsked = LabelAsked<LabelFine>;
struct ForgetEdge {
    EdgeDistance* known;

    void operator()(std::size_t i) const { known[i] = {}; }
};

// --- who comes and goes

/// What has become of one that was outside its zone.
struct Left {
    Located at;
    bool stays;  ///< as spray
    bool far;    ///< where buffer particles are gone
};
struct LeaveZone {
    BecomeBuffer become;
    FoundAt found;
    StateView p;
    const int* which;
    const double* outside;  ///< Zone::outside of each particle [m]
    double gone_beyond;     ///< [m]
    int* gone;
    Left* left;

    void operator()(std::size_t k) const {
        const int at = found.order[k];
        const auto i = static_cast<std::size_t>(which[at]);
        const bool far = outside[i] > gone_beyond, stays = !become(i, found(k));
        if (!stays) gone[i] = far;
        left[at] = {{which[at], {p.x[i], p.y[i], p.z[i]}}, stays, far};
    }
};
struct MarkGone {
    const int* which;
    int* gone;

    void operator()(std::size_t k) const { gone[which[k]] = 1; }
};
struct MarkStaying {
    const int* gone;  ///< null: none is
    const char* own;  ///< copies of another rank's particles go; null: there are none
    int* stays;

    void operator()(std::size_t i) const { stays[i] = !(gone && gone[i]) && (!own || own[i]); }
};
struct MarkParents {
    const Kind* kind;
    const Daughters* daughters;
    const double* outside;  ///< Zone::outside of each particle [m]
    double within;          ///< [m]
    int* marks;

    void operator()(std::size_t i) const { marks[i] = Parent::is(kind[i], daughters[i], outside[i], within); }
};
struct TakeParents {
    StateView p;
    Daughters* daughters;
    const int* which;
    Parent* to;

    void operator()(std::size_t k) const {
        const auto i = static_cast<std::size_t>(which[k]);
        to[k] = {which[k], {p.x[i], p.y[i], p.z[i]}, {p.u[i], p.v[i], p.w[i], p.drho[i]}, daughters[i]};
        daughters[i] = Daughters::all;
    }
};
struct MarkBetween {
    const double* outside;  ///< Zone::outside of each particle [m]
    double from, to;        ///< [m]
    int* marks;

    void operator()(std::size_t i) const { marks[i] = outside[i] > from && outside[i] < to; }
};
struct TakeLocated {
    StateView p;
    const int* which;
    Located* to;

    void operator()(std::size_t k) const {
        const auto i = static_cast<std::size_t>(which[k]);
        to[k] = {which[k], {p.x[i], p.y[i], p.z[i]}};
    }
};
/// Puts them behind the n that are there.
struct AddChildren {
    const Child* daughters;
    FieldsView on;
    std::size_t n;

    void operator()(std::size_t k) const {
        const Child& c = daughters[k];
        const std::size_t i = n + k;
        on.begin(i);
        on.x[i] = c.place.x, on.y[i] = c.place.y, on.z[i] = c.place.z;
        on.u[i] = c.state.u, on.v[i] = c.state.v, on.w[i] = c.state.w, on.drho[i] = c.state.drho;
        on.kind[i] = c.kind, on.id[i] = c.id;
    }
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
/// The first of each pencil among those that give.
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
    PackedPlace* place;

    void operator()(std::size_t k) const { place[k] = wide[order[k]].packed(0); }
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
using HandToBuffers = Hand<FollowCoarser>;
using HandToUnder = Hand<FollowFiner>;
/// The same for places of the host, in their order.
struct HandToHost {
    FoundAt found;
    Given* to;

    void operator()(std::size_t k) const { to[found.order[k]] = found(k); }
};

}  // namespace tw::cuda

#include "sph_solver/refinement/refinement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "sph_solver/backend/stopwatch.h"

namespace tw {

Refinement::Refinement(Level& coarse, Level& fine, Zone zone, const Refinement* outer)
    : coarse_(coarse),
      fine_(fine),
      outer_(outer),
      zone_(std::move(zone)),
      dp_(fine.system().setup.dp),
      excess_(coarse.system().kernel, coarse.system().setup.dp, coarse.system().around.dimensions) {
    coarse.begin_over(zone_, buffer_over_dp * dp_);
    fine.begin_within(zone_);
    label_coarse();
    surplus_at_start_ = surplus();
}

void Refinement::set_zone(Zone zone) {
    const std::optional<Zone::Shift> shift = zone.shift_since(zone_);
    zone_ = std::move(zone);
    if (shift) {
        shifted_.by += shift->by;
        shifted_.turn += shift->turn;
        gone_since_ += shift->by + shift->turn * zone_.pivot_radius();
        return;
    }
    gone_since_ = std::numeric_limits<double>::infinity();
    fine_.maker().forget_edge(With::coarser);
    coarse_.maker().forget_edge(With::finer);
}

AskEdge Refinement::edge(std::initializer_list<double> limits) const {
    const Vec3 pivot = zone_.pivot();
    AskEdge ask{.limits = {},
                .steepest = Zone::steepest,
                .by = shifted_.by,
                .turn = shifted_.turn,
                .pivot = {pivot.x(), pivot.y(), pivot.z()}};
    std::ranges::fill(ask.limits, std::numeric_limits<double>::infinity());
    std::ranges::copy(limits, ask.limits);
    return ask;
}

void Refinement::label_coarse() {
    const LabelCoarse label{
        .overlap = overlap_over_dp * dp_, .again = again_over_dp * dp_, .barren = barren_over_dp * dp_};
    const AskEdge ask =
        edge({-overlap_over_dp * dp_, 0.0, buffer_over_dp * dp_, again_over_dp * dp_, barren_over_dp * dp_});
    coarse_.maker().label(ask, label, zone_);
}

EdgeSteps::Spray Refinement::label_fine() {
    const LabelFine label{.gone_beyond = gone_over_dp * dp_};
    const AskEdge ask = edge({0.0, gone_over_dp * dp_});
    const Asking asking{.of = Giving::all, .apart = fine_apart};
    return fine_.maker().label(ask, label, zone_, coarse_.maker(), asking);
}

void Refinement::relabel() {
    const Stopwatch watch(ledger_.seconds);
    label_coarse();
    if (!fine_.system().near.life.over && !fine_.lists_outlived() && gone_since_ + in_a_step_ < patience_over_dp * dp_)
        return;
    gone_since_ = 0;
    EdgeSteps::Spray spray = label_fine();
    const Comm& ranks = fine_.system().ranks();
    std::vector<std::size_t> fallen;
    for (const Refinement* edge = outer_; edge; edge = edge->outer_) {
        if (ranks.sum(static_cast<std::int64_t>(spray.far.size())) == 0) break;
        const std::vector<char> covered = edge->covers(spray.far);
        std::vector<Located> left;
        for (std::size_t k = 0; k < covered.size(); ++k)
            if (covered[k])
                fallen.push_back(static_cast<std::size_t>(spray.far[k].index));
            else
                left.push_back(spray.far[k]);
        spray.far = std::move(left);
    }
    ledger_.spray = ranks.sum(spray.count - static_cast<std::int64_t>(fallen.size()));
    remove_gone(fallen);
    split_parents();
}

std::vector<char> Refinement::covers(const std::vector<Located>& who) const {
    FieldsAt at{Asking{.of = Giving::all, .apart = fine_apart}};
    for (const Located& one : who) at.places.emplace_back(one.place.x, one.place.y, one.place.z);
    coarse_.fields().interpolate(at);
    std::vector<char> yes;
    for (const float support : at.support) yes.push_back(support >= BecomeBuffer::covered);
    return yes;
}

void Refinement::prolong(double moved, double compressed) {
    const Stopwatch watch(ledger_.seconds);
    const Eigen::Vector3f fall = fine_.system().body_force().cast<float>();
    const FollowCoarser follow{.excess = excess_,
                               .row = fine_.system().density_of_row(),
                               .moved = moved,
                               .compressed = compressed,
                               .fall = {fall.x(), fall.y(), fall.z()}};
    const Asking asking{.apart = fine_apart, .without = &excess_};
    const Followed buffers = fine_.maker().follow_coarser(coarse_.maker(), asking, follow);
    ledger_.orphans = buffers.orphans;
    // that of the coarse level: of those that are to have daughters
    in_a_step_ = moved * std::max(coarse_.system().extremes.speed, std::sqrt(buffers.fastest2));
    gone_since_ += in_a_step_;
}

void Refinement::restrict_over(double moved, double density_before) {
    const Stopwatch watch(ledger_.seconds);
    const Eigen::Vector3f fall = static_cast<float>(moved) * coarse_.system().body_force().cast<float>();
    const FollowFiner follow{
        .excess = excess_, .row = coarse_.system().density_of_row(), .fall = {fall.x(), fall.y(), fall.z()}};
    const Asking asking{.of = Giving::not_buffers,
                        .apart = coarse_apart,
                        .density_before = density_before,
                        .want_compression = true,
                        .without = &excess_};
    const Followed under = coarse_.maker().follow_finer(fine_.maker(), asking, follow);
    ledger_.orphans += under.orphans;
}

double Refinement::mass_under(const KindCounts& coarse) const {
    return coarse_.system().mass * double(coarse.under() - coarse.under_beyond);
}

double Refinement::surplus(const KindCounts& coarse, const KindCounts& fine) const {
    const std::int64_t water = fine_.fields().count() - fine.buffers - fine.water_beyond - ledger_.spray;
    return fine_.system().mass * double(water) - mass_under(coarse);
}

double Refinement::mass_drift(const KindCounts& coarse, const KindCounts& fine) const {
    const double mass = mass_under(coarse);
    return mass > 0 ? (surplus(coarse, fine) - surplus_at_start_) / mass : 0;
}

}  // namespace tw

// Who the particles of a level on a device are where it meets another size, and how they follow it.
#include <algorithm>

#include "sph_solver/backend/for_particles.h"
#include "sph_solver/levels/arrays_on_device.h"
#include "sph_solver/pair_loops/interpolate.h"

namespace tw {

// --- who is what
// ------------------------------------------------------------------------------------------------------

template <class Label>
void LevelOnDevice::label_all(const cuda::LabelKnown<Label>& task, const Zone& zone) {
    Arrays& on = *on_;
    cuda::launch(*device_, task, on.p.size());
    on_host_ = false;
    const auto asked = static_cast<std::size_t>(on.count.value(0));
    if (asked == 0) return;
    const std::vector<Located> at = located(task.unknown, asked);
    std::vector<double> outside(asked);
    for_particles(asked, [&](std::size_t k) {
        const V3<double>& x = at[k].place;
        outside[k] = zone.outside({x.x, x.y, x.z});
    });
    on.asked_outside.upload(outside);
    cuda::launch(*device_, cuda::LabelAsked<Label>{task, on.asked_outside.data()}, asked);
}

void LevelOnDevice::label(const AskEdge& ask, LabelCoarse label, const Zone& zone) {
    if (host_counts_) upload_state();
    Arrays& on = *on_;
    on.at_edge.resize(on.p.size()), on.outside.resize(on.p.size());
    on.count.set_zero();
    label.kind = on.p.kind.data(), label.daughters = on.p.daughters.data();
    label_all(cuda::LabelCoarseKnown{ask, label, on.p.view(), on.p.from_finer_edge.data(), on.outside.data(),
                                     on.at_edge.data(), on.count.data()},
              zone);
}

/// Those that are marked in `following`: how many, in `which`.
std::size_t LevelOnDevice::list_marked() {
    Arrays& on = *on_;
    const auto marked = static_cast<std::size_t>(on.following.add_up());
    on.which.resize(marked);
    cuda::launch(*device_, cuda::ListMarked{on.following.numbers(), on.following.before(), on.which.data()},
                 on.p.size());
    return marked;
}

/// The same of those that this rank owns.
std::size_t LevelOnDevice::list_marked_own() {
    Arrays& on = *on_;
    if (shared()) cuda::launch(*device_, cuda::MarkOwn{on.own.data(), on.following.marks()}, on.p.size());
    return list_marked();
}

EdgeSteps::Spray LevelOnDevice::label(const AskEdge& ask, LabelFine label, const Zone& zone, EdgeSteps& coarser,
                                      const Asking& asking) {
    if (host_counts_) upload_state();
    Arrays& on = *on_;
    const std::size_t n = on.p.size();
    on.at_edge.resize(n), on.outside.resize(n), on.gone_at_edge.resize(n);
    on.count.set_zero();
    label.kind = on.p.kind.data(), label.leaves = on.following.of(n), label.gone = on.gone_at_edge.data();
    label_all(cuda::LabelFineKnown{ask, label, on.p.view(), on.p.from_edge.data(), on.outside.data(), on.at_edge.data(),
                                   on.count.data()},
              zone);
    const std::size_t leaving = list_marked_own();
    if (leaving == 0 && !shared()) return {};
    on.left_zone.resize(leaving);
    cuda::launch(*device_,
                 cuda::LeaveZone{.become = {on.p.kind.data()},
                                 .found = ask_other(coarser, 0, asking),
                                 .p = on.p.view(),
                                 .which = on.which.data(),
                                 .outside = on.outside.data(),
                                 .gone_beyond = label.gone_beyond,
                                 .gone = label.gone,
                                 .left = on.left_zone.data()},
                 leaving);
    std::vector<cuda::Left> left(leaving);
    on.left_zone.download(left);
    Spray spray;
    for (const cuda::Left& l : left) {
        spray.count += l.stays;
        if (l.stays && l.far) spray.far.push_back(l.at);
    }
    loops_.halo().exchange({of_each(on.p.kind.data())});
    return spray;
}

std::int64_t LevelOnDevice::remove_gone(const std::vector<std::size_t>& more) {
    Arrays& on = *on_;
    const std::size_t n = on.p.size();
    on.which.upload(std::vector<int>(more.begin(), more.end()));
    cuda::launch(*device_, cuda::MarkGone{on.which.data(), on.gone_at_edge.data()}, more.size());
    cuda::launch(*device_, cuda::MarkStaying{on.gone_at_edge.data(), or_null(on.own), on.following.of(n)}, n);
    const std::size_t staying = list_marked();
    const std::int64_t merges =
        share_.ranks().sum(static_cast<std::int64_t>(n) - static_cast<std::int64_t>(share_.copies() + staying));
    if (merges > 0) {
        keep(staying);
        on.gone_at_edge.resize(staying);
    }
    on.gone_at_edge.set_zero();
    return merges;
}

/// Of all particles those that are marked in `following`, so many, which are listed in `which`.
void LevelOnDevice::keep(std::size_t marked) {
    Arrays& on = *on_;
    on.p.each_moving_with(on.sorted,
                          [&](const auto& field, auto& sorted) { sorted.resize(field.size() > 0 ? marked : 0); });
    cuda::launch(*device_, cuda::Reorder{on.which.data(), on.p.all(), on.sorted.all()}, marked);
    on.p.each_moving_with(on.sorted, [](auto& field, auto& sorted) { field.swap(sorted); });
    level_.particles.resize(marked);
    on_host_ = false;
    if (!shared()) return;
    const std::size_t pencils = on.start.size();
    on.new_start.resize(pencils);
    cuda::launch(*device_, cuda::StartMarked{on.start.data(), on.following.before(), on.new_start.data()}, pencils);
    on.new_start.download(level_.near.start);
    share_.note_let_go(marked);
    upload_own();
}

std::vector<Parent> LevelOnDevice::find_parents(double within) {
    Arrays& on = *on_;
    const std::size_t n = on.p.size();
    cuda::launch(
        *device_,
        cuda::MarkParents{on.p.kind.data(), on.p.daughters.data(), on.outside.data(), within, on.following.of(n)}, n);
    std::vector<Parent> parents(list_marked());
    on.parents.resize(parents.size());
    cuda::launch(*device_, cuda::TakeParents{on.p.view(), on.p.daughters.data(), on.which.data(), on.parents.data()},
                 parents.size());
    on.parents.download(parents);
    on_host_ = false;
    if (shared())
        std::erase_if(parents, [&](const Parent& p) { return !share_.owns(static_cast<std::size_t>(p.index)); });
    return parents;
}

/// The first `n` of a list, with their places.
std::vector<Located> LevelOnDevice::located(const int* which, std::size_t n) {
    Arrays& on = *on_;
    std::vector<Located> on_host(n);
    on.located.resize(n);
    cuda::launch(*device_, cuda::TakeLocated{on.p.view(), which, on.located.data()}, n);
    on.located.download(on_host);
    return on_host;
}

std::vector<Located> LevelOnDevice::marked() {
    const std::size_t n = list_marked_own();
    return located(on_->which.data(), n);
}

std::vector<Located> LevelOnDevice::between(double from, double to) {
    const std::size_t n = on_->p.size();
    cuda::launch(*device_, cuda::MarkBetween{on_->outside.data(), from, to, on_->following.of(n)}, n);
    return marked();
}

std::vector<Located> LevelOnDevice::buffers() {
    const std::size_t n = on_->p.size();
    cuda::launch(*device_, cuda::MarkFollowing{on_->p.kind.data(), true, on_->following.of(n)}, n);
    return marked();
}

void LevelOnDevice::add(const std::vector<Child>& daughters) {
    Arrays& on = *on_;
    if (shared()) {  // copies would stand among them
        cuda::launch(*device_, cuda::MarkStaying{nullptr, on.own.data(), on.following.of(on.p.size())}, on.p.size());
        keep(list_marked());
    }
    const std::size_t n = on.p.size();
    level_.particles.resize(n + daughters.size());
    on.p.each_moving_with(level_.particles, [](auto& field, const auto& on_host) { field.grow(on_host.size()); });
    on.daughters.upload(daughters);
    cuda::launch(*device_, cuda::AddChildren{on.daughters.data(), on.p.all(), n}, daughters.size());
    if (shared()) share_.own_added(), upload_own();
    on_host_ = false;
}

void LevelOnDevice::forget_edge(With whose) {
    if (host_counts_) upload_state();
    cuda::Array<EdgeDistance>& known = whose == With::coarser ? on_->p.from_edge : on_->p.from_finer_edge;
    cuda::launch(*device_, cuda::ForgetEdge{known.data()}, known.size());
    on_host_ = false;
}

// --- who follows
// ------------------------------------------------------------------------------------------------------

std::size_t LevelOnDevice::list_following(bool buffers) {
    if (host_counts_) upload_state();
    Arrays& on = *on_;
    const std::size_t n = on.p.size();
    cuda::launch(*device_, cuda::MarkFollowing{on.p.kind.data(), buffers, on.following.of(n)}, n);
    return list_marked_own();
}

/// How many of `n` are orphans.
template <class Task>
std::int64_t LevelOnDevice::hand(const Task& task, std::size_t n) {
    cuda::launch(*device_, task, n);
    on_host_ = false;
    return on_->orphans.add_up();
}

double LevelOnDevice::fastest2_of_following() {
    Arrays& on = *on_;
    const cuda::FastestOf of{on.p.view(), on.which.data()};
    return loops_.largest(of, on.which.size());
}

Followed LevelOnDevice::follow_coarser(EdgeSteps& coarser, const Asking& asking, FollowCoarser follow) {
    Arrays& on = *on_;
    const std::size_t n = list_following(true);
    follow.p = on.p.view(), follow.trend = on.p.trend.data();
    Followed followed{fastest2_of_following(), 0};
    if (n == 0 && !shared()) return followed;
    const cuda::FoundAt found = ask_other(coarser, follow.moved, asking);
    followed.orphans = hand(cuda::HandToBuffers{follow, found, on.which.data(), on.orphans.of(n)}, n);
    loops_.halo().exchange({of_each(on.p.trend.data()), of_each(on.p.drho.data())});
    return share_.ranks().sum(followed);
}

Followed LevelOnDevice::follow_finer(EdgeSteps& finer, const Asking& asking, FollowFiner follow) {
    Arrays& on = *on_;
    const std::size_t n = list_following(false);
    if (n == 0 && !shared()) return {};
    follow.p = on.p.view(), follow.kind = on.p.kind.data();
    follow.shift = on.p.shift_support.data(), follow.compression = on.p.compression.data();
    const cuda::FoundAt found = ask_other(finer, 0, asking);
    const std::int64_t orphans = hand(cuda::HandToUnder{follow, found, on.which.data(), on.orphans.of(n)}, n);
    loops_.halo().exchange({of_each(on.p.u.data()), of_each(on.p.v.data()), of_each(on.p.w.data()),
                            of_each(on.p.drho.data()), of_each(on.p.compression.data())});
    return share_.ranks().sum(Followed{0, orphans});
}

}  // namespace tw

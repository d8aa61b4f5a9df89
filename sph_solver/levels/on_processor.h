#pragma once
#include <vector>

#include "sph_solver/levels/rank_share.h"
#include "sph_solver/levels/step_maker.h"

namespace tw {

/// A level whose steps this processor makes, of what its rank holds of it.
class LevelOnProcessor : public StepMaker {
public:
    /// Both must outlive this.
    LevelOnProcessor(ParticleSystem& level, RankShare& share) : level_(level), share_(share) {}

    // all is on the host
    void copy_all_to_host() override {}
    void copy_motion_to_host() override {}
    void copy_to_host(const std::vector<std::size_t>&) override {}
    void note_changed_state() override {}
    KindCounts count(CountKinds kinds) override;
    double bytes_on_device() const override { return 0; }

    void make_lists(double drift) override;
    void pack_state() override;
    void prune(double drift) override;
    void find_walls() override;
    std::int64_t live_pairs() const override;
    Near find_neighbours(StepMaker& other, const Reaches& reaches, RoomForLists& room) override;

    StepView step_view(double t) override { return level_.step_view(t, share_.halo()); }
    void first_pair_loop(const OtherSums* other) override;
    void exchange_first_sums() override { share_.exchange_first_sums(); }
    void mark_surface() override;
    void compress(double compress, double drift) override;
    void refresh_images(double t) override;
    void press_walls() override;
    void exchange_pressures() override { level_.walls.halo().exchange(level_.walls.pressures().data()); }
    void second_pair_loop(double t) override;
    void exchange_rates() override {
        share_.halo().exchange(level_.particles.rate.data(), level_.particles.shift_support.data());
    }
    void copy_loads_to_host() override {}

    Vec3 centre_of_cluster(std::size_t k) const override;
    std::vector<std::int32_t> copy_pressed_to_host(MayBePressed condition) override;
    void push(const std::vector<std::int32_t>& which, const std::vector<V3<float>>& accelerations) override;
    std::vector<Moved> move(const Move& by, const Hold& hold) override;

    void sample(SortedPlaces& points, const ExtrapolateData& to) override;

    void label(const AskEdge& ask, LabelCoarse label, const Zone& zone) override;
    Spray label(const AskEdge& ask, LabelFine label, const Zone& zone, EdgeSteps& coarser,
                const Asking& asking) override;
    std::int64_t remove_gone(const std::vector<std::size_t>& more) override;
    std::vector<Parent> find_parents(double within) override;
    std::vector<Located> between(double from, double to) override;
    std::vector<Located> buffers() override;
    void add(const std::vector<Child>& daughters) override;
    void forget_edge(With whose) override;
    void interpolate(FieldsAt& at) override;
    Followed follow_coarser(EdgeSteps& coarser, const Asking& asking, FollowCoarser follow) override;
    Followed follow_finer(EdgeSteps& finer, const Asking& asking, FollowFiner follow) override;

private:
    /// Where neighbours among the particles and images are looked for.
    std::vector<Source> sources() const;
    void interpolate_here(FieldsAt& at);
    std::vector<std::size_t> own_of_kind(bool (*of)(Kind)) const;

    ParticleSystem& level_;
    RankShare& share_;
    std::vector<double> outside_;  ///< of each particle from the edge of the finer zone, at the last labelling [m]
    std::vector<int> gone_;        ///< of each particle of a level that has buffer particles
};

}  // namespace tw

#pragma once
#include <memory>

#include "sph_solver/cuda/driver.h"
#include "sph_solver/cuda/edges.h"
#include "sph_solver/cuda/search.h"
#include "sph_solver/levels/loops_on_device.h"
#include "sph_solver/levels/rank_share.h"
#include "sph_solver/levels/step_maker.h"
#include "sph_solver/loops/wall_motion.h"
#include "sph_solver/pair_loops/views.h"

namespace tw {

/// A level whose steps are made by a graphics processor. In a step the host gets the loads of the clusters at walls,
/// the forces on the dummies of bodies that deform, the extremes, and the few particles that a wall has to hold; when
/// lists are made, the places of those near walls, of which it finds the nearest; and at the edge of a zone who is to
/// have daughters. It sends where the dummies are, and how bodies and the surfaces of those that deform move.
class LevelOnDevice : public StepMaker {
public:
    /// Both must outlive this; lists are made afterwards.
    LevelOnDevice(ParticleSystem& level, RankShare& share, std::shared_ptr<cuda::Device> device);
    ~LevelOnDevice() override;

    void copy_all_to_host() override;
    void copy_motion_to_host() override;
    void copy_to_host(const std::vector<std::size_t>& particles) override;
    void note_changed_state() override { host_counts_ = true; }
    KindCounts count(CountKinds kinds) override;
    double bytes_on_device() const override;

    void make_lists(double drift) override;
    void pack_state() override;
    void prune(double drift) override;
    void find_walls() override;
    std::int64_t live_pairs() const override;
    Near find_neighbours(StepMaker& other, const Reaches& reaches, RoomForLists& room) override;

    StepView step_view(double t) override;
    void first_pair_loop(const OtherSums* other) override;
    void exchange_first_sums() override;
    void mark_surface() override;
    void compress(double compress, double drift) override;
    void refresh_images(double t) override { refresh_images(t, true); }
    void press_walls() override;
    void exchange_pressures() override;
    void second_pair_loop(double t) override;
    void exchange_rates() override;
    void copy_loads_to_host() override;

    Vec3 centre_of_cluster(std::size_t k) const override { return centres_[k]; }
    std::vector<std::int32_t> copy_pressed_to_host(MayBePressed condition) override;
    void push(const std::vector<std::int32_t>& which, const std::vector<V3<float>>& accelerations) override;
    std::vector<Moved> move(const Move& of_host, const Hold& hold) override;

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
    struct Arrays;
    WaterView water() const;
    WallView walls() const;
    void upload_state();
    void upload_sorted_dummies();
    void upload_dummies();
    NearWalls near_walls();
    const SurfaceMotion* upload_surfaces();
    std::vector<cuda::DeviceSource> sources() const;
    bool shared() const { return share_.ranks().many(); }
    void cross_faces();
    void cross_and_hold(double reach);
    std::vector<std::int32_t> list_entered();
    void keep(std::size_t marked);
    void upload_own();
    void note_own();
    void note_work();
    void sort_particles(const std::uint8_t* left);
    void find_images(double reach);
    void list_walls(const Reaches& reaches);
    void refresh_images(double t, bool with_stress);
    void fetch(const std::vector<std::int32_t>& particles);
    void put_back(const std::vector<std::int32_t>& held);  ///< after the host has held them
    /// Fields at places in this level's fixed-point units.
    cuda::FoundAt ask(const cuda::Array<WidePlace>& wide, const Asking& asking);
    std::vector<cuda::DeviceSource> note_giving(const Asking& asking);
    template <class Label>
    void label_all(const cuda::LabelKnown<Label>& task, const Zone& zone);
    std::size_t list_marked();
    std::size_t list_marked_own();
    std::vector<Located> located(const int* which, std::size_t n);
    std::vector<Located> marked();
    cuda::FoundAt ask_other(EdgeSteps& level, double ahead, const Asking& asking);
    cuda::FoundAt ask_ranks(EdgeSteps& level, double ahead, const Asking& asking);
    void interpolate_here(FieldsAt& at);
    std::size_t list_following(bool buffers);
    template <class Task>
    std::int64_t hand(const Task& task, std::size_t n);
    double fastest2_of_following();

    ParticleSystem& level_;
    RankShare& share_;
    std::shared_ptr<cuda::Device> device_;
    LoopsOnDevice loops_;
    std::unique_ptr<Arrays> on_;
    std::vector<Vec3> centres_;
    bool on_host_ = true, order_on_host_ = true;  ///< the host has the state; and who stands where
    bool host_counts_ = true;                  ///< the device has not taken what the host has
};

}  // namespace tw

#pragma once
#include <map>
#include <vector>

#include "sph_solver/cuda/launch.h"
#include "sph_solver/levels/lists_on_device.h"
#include "sph_solver/levels/on_device.h"

namespace tw {

template <class T>
T* or_null(const cuda::Array<T>& array) {
    return array.size() > 0 ? array.data() : nullptr;
}

struct LevelOnDevice::Arrays {
    cuda::Device& device;
    /// The particles' quantities (fields/field_list.h).
    struct Fields : FieldsAs<cuda::Array> {
        explicit Fields(cuda::Device& d) {
            each([&d](auto& field) { field.live_on(d); });
        }
        template <class Function>
        void each(const Function& f) {
            FieldsAs::each(*this, *this, [&f](auto& field, auto&, auto) { f(field); });
        }
        /// Calls `f(field, other)` for each of those that move with particles, and what `others` has of it.
        template <class Others, class Function>
        void each_moving_with(Others& others, const Function& f) {
            FieldsAs::each_moving(*this, others, f);
        }
        FieldsView all() const {
            FieldsView view;
            FieldsAs::each(*this, view, [](const auto& field, auto& pointer, auto) { pointer = or_null(field); });
            return view;
        }
        StateView view() const { return {x.data(), y.data(), z.data(), u.data(), v.data(), w.data(), drho.data()}; }
        std::size_t size() const { return x.size(); }
    };
    Fields p{device}, sorted{device};  ///< of `sorted` those that move
    cuda::Array<std::uint32_t> surface{device};

    // who stands where
    cuda::Bins bins;
    RunningSum entered{device}, images{device};
    cuda::Array<int> gone{device};
    cuda::Array<std::uint8_t> left{device};
    cuda::Array<WidePlace> wide{device};
    // of several ranks only: which particles and pencils are its own; which others may have to hear of
    cuda::Array<char> own{device}, own_pencils{device}, inner_pencils{device};
    cuda::Array<int> start{device}, new_start{device};  ///< first particle of each pencil
    cuda::Array<int> at_border{device};
    RunningSum work{device};
    SortedOnDevice order{device, bins}, image_order{device, bins};
    cuda::Array<Link> found{device}, links{device};
    cuda::Array<LinkMap> maps{device};
    ClustersOnDevice clusters{device};
    ListsOnDevice lists{device}, wall_lists{device};

    cuda::Array<PackedPlace> wall_place{device};
    cuda::Array<float> wall_p{device};
    cuda::Array<PackedVelocityDensity> sliding{device};  ///< empty: no surface slides, or no effect asks
    cuda::Array<WallVelocity> wall_velocity{device};
    cuda::Array<WallAcceleration> wall_acceleration{device};
    cuda::Array<WallMotion> motions{device};
    cuda::Array<std::int32_t> body_end{device};
    cuda::Array<WallLoad> wall_load{device};
    RunningSum loads{device}, at_wall{device};
    cuda::Array<cuda::ClusterAtWall> clusters_at_walls{device};
    cuda::Array<cuda::NearWall> near_walls{device};
    cuda::Array<cuda::WallFound> walls_found{device};
    /// The dummies of one body.
    struct Part {
        std::size_t first;
        cuda::Array<int> start, pencil;
        cuda::Array<Cluster> clusters;
        ListsOnDevice lists;
    };
    std::vector<Part> parts;
    /// The surface of one body, empty if that is rigid.
    struct WettedSurface {
        std::int64_t times_noted = 0;
        cuda::Array<Corners> corners;
        cuda::Array<V3<double>> noted, velocity;
    };
    std::vector<WettedSurface> surfaces;
    cuda::Array<SurfaceMotion> surface_motions{device};  ///< empty: no body is deformable
    cuda::Array<std::int32_t> pushed{device};
    cuda::Array<V3<float>> pushes{device};

    // where another level's material is within reach
    cuda::Array<Cluster> asking_others{device}, near_others{device};
    ListsOnDevice lists_of_others{device};

    cuda::Array<int> count{device};
    cuda::Array<KindCounts> kinds{device};
    cuda::Array<MovedExtremes> extremes{device};
    cuda::Array<std::int32_t> too_near{device}, fetched{device};
    cuda::Array<cuda::HeldParticle> held{device};

    // what other levels ask for
    RunningSum gives{device};
    cuda::Array<PackedPlace> giving_place{device};
    cuda::Array<PackedVelocityDensity> giving_motion{device};
    cuda::Array<float> giving_support{device}, giving_rate{device};
    cuda::Array<int> giving_start{device}, giving_images{device};
    /// The places where they ask, in order, and what is found there.
    struct Asked {
        SortedOnDevice order;
        ClustersOnDevice clusters;
        ListsOnDevice lists;
        cuda::Array<PackedPlace> place;
        cuda::Array<PackedVelocityDensity> value;
        cuda::Array<float> support, mean_support, compression;
        Asked(cuda::Device& d, const cuda::Bins& bins)
            : order(d, bins), clusters(d), lists(d), place(d), value(d), support(d), mean_support(d), compression(d) {}
    };
    std::map<double, Asked> asked;  ///< by how far apart the places are
    // who follows other levels
    RunningSum following{device}, orphans{device};
    cuda::Array<int> which{device};
    cuda::Array<WidePlace> wide_of_others{device};
    // what other ranks have answered
    cuda::Array<V3<double>> places_ahead{device};
    cuda::Array<int> found_order{device};
    cuda::Array<PackedVelocityDensity> found_value{device};
    cuda::Array<float> found_support{device}, found_mean{device}, found_compression{device};
    cuda::Array<Given> given{device};
    cuda::Array<int> at_edge{device};
    cuda::Array<double> outside{device}, asked_outside{device};  ///< of each; of those that the host was asked about
    cuda::Array<int> gone_at_edge{device};
    cuda::Array<cuda::Left> left_zone{device};
    cuda::Array<Located> located{device};
    cuda::Array<Parent> parents{device};
    cuda::Array<Child> daughters{device};

    Arrays(cuda::Device& d, const cuda::Bins& of_pencils) : device(d), bins(of_pencils) {}

    double bytes() {
        double sum = 0;
        const auto add = [&](const auto&... array) { ((sum += double(array.bytes())), ...); };
        p.each(add), sorted.each(add);
        add(surface, surface_motions, pushed, pushes, asking_others, near_others, lists_of_others, wall_velocity,
            wall_acceleration, motions, entered, images, gone, left, wide, order, image_order, found, links, maps,
            clusters, lists, wall_lists, wall_place, wall_p, sliding, body_end, wall_load, loads, at_wall,
            clusters_at_walls, near_walls, walls_found, count, kinds, extremes, too_near, fetched, held, gives,
            giving_place, giving_motion, giving_support, giving_rate, giving_start, giving_images, following, orphans,
            which, own, own_pencils, inner_pencils, start, new_start, at_border, work, places_ahead, found_order,
            found_value, found_support, found_mean, found_compression, wide_of_others, given, at_edge, outside,
            asked_outside, gone_at_edge, left_zone, located, parents, daughters);
        for (const auto& [apart, a] : asked)
            add(a.order, a.clusters, a.lists, a.place, a.value, a.support, a.mean_support, a.compression);
        for (const Part& part : parts) add(part.start, part.pencil, part.clusters, part.lists);
        for (const WettedSurface& of : surfaces) add(of.corners, of.noted, of.velocity);
        return sum;
    }
};

}  // namespace tw

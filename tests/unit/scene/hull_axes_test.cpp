// Surfaces as people have them: halves, other axes, upside down, with the keel at z = 0, in coordinates of a map.
#include "scene/solids/hull_axes.h"

#include <algorithm>

#include "meshes/generate.h"
#include "meshes/symmetric.h"
#include "scene_text.h"

namespace tw::test {
namespace hull_axes_test {

Surface upright() { return make_hull("prismatic", {{"length", 4}, {"beam", 1}, {"deadrise", 0.349}}); }

template <class Map>
Surface mapped(Surface s, const Map& map) {
    for (Vec3& p : s.points) p = map(p);
    return s;
}
Surface flipped(Surface s) {
    for (auto& t : s.triangles) std::swap(t[1], t[2]);
    return s;
}

/// The starboard half of the hull, open along y = 0.
Surface open_half() {
    const Surface whole = made_symmetric(upright(), 0);
    Surface half{whole.points, {}};
    for (const auto& t : whole.triangles)
        if (std::ranges::all_of(t, [&](int k) { return whole.points[static_cast<std::size_t>(k)].y() >= 0; }))
            half.triangles.push_back(t);
    return welded(half);
}

/// The half of a wedge, with a face in y = 0.
Surface closed_half() {
    Surface s;
    for (const double x : {-2.0, 2.0})
        for (const Vec3& p : {Vec3(x, 0, 0), Vec3(x, 0.5, 0.4), Vec3(x, 0, 0.4)}) s.points.push_back(p);
    s.triangles = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
    return s;
}

std::string file_scene(const Surface& surface, const std::string& keys = "draft = 0.2\n") {
    write_stl(scratch() / "hull.stl", surface);
    return "[hull]\nfile = \"hull.stl\"\n" + keys + "[motion]\nspeed = 8\n[resolution]\nnear_hull = 0.1\n" + one_size;
}

bool has(const std::vector<Finding>& findings, const std::string& name, const std::string& part = "") {
    return std::ranges::any_of(
        findings, [&](const Finding& f) { return f.name == name && f.message.find(part) != std::string::npos; });
}

TEST(HullAxes, AHalfHullIsMirroredAndItIsSaid) {
    const auto port = [](const Vec3& p) { return Vec3(p.x(), -p.y(), p.z()); };
    const double volume = mass_properties(upright()).volume;
    for (const Surface& half : {open_half(), flipped(mapped(open_half(), port))}) {
        const Scene s = scene_of(file_scene(half));
        EXPECT_NEAR(s.hull->beam, 1, 1e-6);
        EXPECT_NEAR(s.hull->mass.volume, volume, 1e-6 * volume);
        EXPECT_TRUE(has(s.hull->findings, "mirrored", "1 m wide"));
        EXPECT_TRUE(scene_of(file_scene(half, "draft = 0.2\nhalf = true\n")).hull->half);
    }
    const Scene wedge = scene_of(file_scene(closed_half()));
    EXPECT_NEAR(wedge.hull->mass.volume, 0.8, 1e-6);
    EXPECT_TRUE(has(wedge.hull->findings, "mirrored"));
}

TEST(HullAxes, AWholeHullIsNoHalf) {
    EXPECT_FALSE(is_half(upright()));
    const auto beside = [](const Vec3& p) { return Vec3(p.x(), p.y() + 0.5, p.z()); };
    EXPECT_FALSE(is_half(mapped(upright(), beside)));
    EXPECT_FALSE(is_half(mapped(make_hull("box", {{"length", 2}, {"beam", 1}, {"height", 0.5}}), beside)));
}

TEST(HullAxes, OtherAxesAreNoticedAndTheAdviceMendsThem) {
    for (const HullShape& shape : hull_shapes())
        EXPECT_TRUE(check_axes(make_hull(shape.name, {})).empty()) << shape.name;
    const Surface up_is_y = mapped(upright(), [](const Vec3& p) { return Vec3(p.x(), p.z(), -p.y()); });
    EXPECT_TRUE(has(check_axes(up_is_y), "lying", "axes = \"x-zy\""));
    EXPECT_TRUE(has(scene_of(file_scene(up_is_y)).hull->findings, "lying"));
    EXPECT_FALSE(has(scene_of(file_scene(up_is_y, "draft = 0.2\naxes = \"x-zy\"\n")).hull->findings, "lying"));
    EXPECT_NE(complaint(file_scene(up_is_y, "draft = 0.2\nhalf = true\n")).find("axes = \"x-zy\""), std::string::npos);
    const Surface on_its_side = mapped(upright(), [](const Vec3& p) { return Vec3(p.x(), -p.z(), p.y()); });
    EXPECT_TRUE(has(check_axes(on_its_side), "lying", "axes = \"xz-y\""));
    const Surface turned = mapped(make_hull("seaplane", {}), [](const Vec3& p) { return Vec3(-p.y(), p.x(), p.z()); });
    EXPECT_TRUE(has(check_axes(turned), "across", "\"y-xz\""));
    EXPECT_FALSE(has(scene_of(file_scene(turned, "draft = 0.2\naxes = \"y-xz\"\n")).hull->findings, "across"));
    const Surface on_its_deck = mapped(upright(), [](const Vec3& p) { return Vec3(p.x(), -p.y(), -p.z()); });
    EXPECT_TRUE(has(check_axes(on_its_deck), "upside_down", "axes = \"x-y-z\""));
    EXPECT_FALSE(
        has(scene_of(file_scene(on_its_deck, "draft = 0.2\naxes = \"x-y-z\"\n")).hull->findings, "upside_down"));
    EXPECT_NE(complaint(file_scene(flipped(upright()))).find("inverted"), std::string::npos);
}

TEST(HullAxes, TurnShapesAsTheyTurnFiles) {
    const std::string wedge =
        "[tank]\nsize = [4, 1, 1]\n[resolution]\nnear_hull = 0.05\n[[water_block]]\n"
        "min = [0, 0, 0]\nmax = [1, 1, 0.5]\n[[obstacle]]\nshape = \"wedge\"\nwidth = 0.4\n"
        "span = 0.5\ndeadrise = \"45 deg\"\nposition = [2, 0.5, 0.4]\n";
    const auto height = [](const Scene& s) {  // of the wedge's centre over its middle: its keel is the thin end
        const Surface& solid = s.obstacles.at(0).surface;
        return mass_properties(solid).centroid.z() - 0.5 * (solid.bounds().min.z() + solid.bounds().max.z());
    };
    EXPECT_GT(height(scene_of(wedge)), 0.02) << "keel down";
    const Scene turned = scene_of(wedge + "axes = \"x-y-z\"\n"), mirrored = scene_of(wedge + "axes = \"xy-z\"\n");
    EXPECT_LT(height(turned), -0.02);
    EXPECT_NEAR(turned.obstacles[0].surface.bounds().max.z(), 0.4, 1e-9) << "it is turned where it stands";
    for (const Scene* s : {&turned, &mirrored})
        EXPECT_GT(mass_properties(s->obstacles[0].surface).volume, 0) << "inside is inside";
}

TEST(HullAxes, AKeelAtTheWaterLineNeedsADraft) {
    for (const double below : {1e-9, 3e-3}) {
        const Surface s = mapped(upright(), [&](const Vec3& p) { return Vec3(p.x(), p.y(), p.z() - below); });
        const std::string message = complaint(file_scene(s, ""));
        EXPECT_NE(message.find("[hull] file = \"hull.stl\": the hull barely touches the water"), std::string::npos)
            << message;
        EXPECT_NE(message.find("give draft"), std::string::npos) << message;
        EXPECT_EQ(complaint(file_scene(s)), "");
    }
}

TEST(HullAxes, CoordinatesOfAMapAreTakenOffByTheAdvice) {
    const Vec3 offset(500123, 5400456, 12);
    const Surface there = mapped(upright(), [&](const Vec3& p) { return Vec3(p + offset); });
    const std::vector<Finding> findings = check_surface(there);
    EXPECT_TRUE(has(findings, "far_from_origin", "take (500123, 5400456, 12) m off"));
    EXPECT_TRUE(usable(check_surface(mapped(there, [&](const Vec3& p) { return Vec3(p - offset); }))));
}

// What half = true is refused with has to be what mends it.
TEST(HullAxes, OneHullOfACatamaranIsNotAdvisedToBeSolvedAloneBesideTheMiddle) {
    const auto message = [](const std::string& keys, double y) {
        return complaint(file_scene(mapped(upright(), [y](const Vec3& p) { return Vec3(p.x(), p.y() + y, p.z()); }),
                                    "draft = 0.2\nhalf = true\n" + keys));
    };
    for (const std::string& m :
         {message("", 2), message("", -2), message("position = [0, 2]\n", 0), message("", 0.3)}) {
        EXPECT_NE(m.find("the hull lies beside y = 0"), std::string::npos) << m;
        EXPECT_NE(m.find("of a catamaran a file with both hulls"), std::string::npos) << m;
        EXPECT_EQ(m.find("half = false"), std::string::npos) << m;
    }
    EXPECT_EQ(message("position = [0, -2]\n", 2), "") << "a whole hull whose file has its origin elsewhere";
}

TEST(HullAxes, AHullWithYUpIsAdvisedToBeTurnedAndNotToBeSolvedWhole) {
    const auto y_up = [](const Vec3& p) { return Vec3(p.x(), p.z(), -p.y()); };
    const auto short_one = [&](const Vec3& p) { return y_up(Vec3(0.2 * p.x(), p.y(), p.z())); };
    const std::string keys = "draft = 0.2\nhalf = true\n";
    for (const Surface& hull : {mapped(upright(), y_up), mapped(upright(), short_one)}) {
        const std::string m = complaint(file_scene(hull, keys));
        EXPECT_NE(m.find("axes = \"x-zy\""), std::string::npos) << m;
        EXPECT_EQ(m.find("half = false"), std::string::npos) << m;
    }
    EXPECT_EQ(complaint(file_scene(mapped(upright(), y_up), keys + "axes = \"x-zy\"\n")), "");
}

}  // namespace hull_axes_test
}  // namespace tw::test

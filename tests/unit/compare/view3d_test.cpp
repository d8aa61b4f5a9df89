#include "compare/report/view3d.h"

#include <gtest/gtest.h>
#include <openssl/evp.h>
#include <zlib.h>

#include <nlohmann/json.hpp>
#include <random>

#include "base/atomic_file.h"
#include "compare/report/colours.h"
#include "compare/report/drawn_solids.h"
#include "compare/report/page.h"
#include "record/water_surface.h"
#include "tests/unit/compare/synthetic_pair.h"
#include "tests/unit/record/example_record.h"

namespace tw {
namespace view3d_test {

using Json = nlohmann::json;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }
std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
    return n;
}
std::string between(const std::string& text, const std::string& begin, const std::string& end) {
    const auto a = text.find(begin);
    if (a == std::string::npos) return {};
    const auto b = text.find(end, a + begin.size());
    return b == std::string::npos ? std::string{} : text.substr(a + begin.size(), b - a - begin.size());
}
std::vector<unsigned char> bytes_of(const std::string& base64) {
    std::vector<unsigned char> bytes(base64.size() + 1);
    const int n = EVP_DecodeBlock(bytes.data(), reinterpret_cast<const unsigned char*>(base64.data()),
                                  static_cast<int>(base64.size()));
    EXPECT_GE(n, 0);
    const int padding = base64.ends_with("==") ? 2 : base64.ends_with("=") ? 1 : 0;
    bytes.resize(static_cast<std::size_t>(std::max(0, n - padding)));
    return bytes;
}
/// What the page's script makes of a block (view3d_mesh.h): of each surface its places, as shares of the box's edges, and
/// the corners of its triangles.
void unpack(Json& into, const Json& packed) {
    const std::vector<unsigned char> bytes = bytes_of(packed["block"].get<std::string>());
    std::size_t count = 0;
    for (const Json& n : packed["points"]) count += 3 * n.get<std::size_t>();
    for (const Json& n : packed["triangles"]) count += 3 * n.get<std::size_t>();
    std::vector<unsigned char> plain(2 * count + 1);
    uLongf size = plain.size();
    ASSERT_EQ(uncompress(plain.data(), &size, bytes.data(), bytes.size()), Z_OK);
    ASSERT_EQ(size, 2 * count);
    std::size_t at = 0;
    const auto row = [&](std::size_t n) {
        std::vector<unsigned> numbers(n);
        unsigned number = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const unsigned folded = plain[at + i] | static_cast<unsigned>(plain[at + n + i]) << 8;
            number = (number + ((folded & 1) != 0 ? 65535 - (folded >> 1) : folded >> 1)) & 65535;
            numbers[i] = number;
        }
        at += 2 * n;
        return numbers;
    };
    const double steps = packed["steps"];
    Json points = Json::array(), triangles = Json::array();
    for (const Json& n : packed["points"]) {
        Json axes = Json::array();
        for (int axis = 0; axis < 3; ++axis) {
            Json shares = Json::array();
            for (const unsigned place : row(n)) shares.push_back(place / steps);
            axes.push_back(shares);
        }
        points.push_back(axes);
    }
    for (const Json& n : packed["triangles"]) triangles.push_back(row(3 * n.get<std::size_t>()));
    into["points"] = points, into["triangles"] = triangles;
}

Json data_of(const std::string& html) {
    Json data = Json::parse(between(html, "<script type=\"application/json\" id=\"view3d-data\">", "</script>"));
    for (Json& source : data["sources"]) unpack(source, source["water"]);
    for (Json& hull : data["hulls"]) {
        unpack(hull, hull["surface"]);
        for (const char* of : {"points", "triangles"}) hull[of] = Json(hull[of][0]);
    }
    return data;
}

std::vector<Vec3> points(const Json& data, const Json& shares) {
    const Json& box = data["box"];
    std::vector<Vec3> out(shares[0].size());
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t i = 0; i < out.size(); ++i) {
            const double low = box[0][axis], high = box[1][axis];
            out[i][static_cast<Eigen::Index>(axis)] = low + shares[axis][i].get<double>() * (high - low);
        }
    return out;
}
/// Half a step of the water's positions, and the single precision of the surface filter [m].
double tolerance(const Json& data, std::size_t axis) {
    return (data["box"][1][axis].get<double>() - data["box"][0][axis].get<double>()) / 8190 + 1e-6;
}
Box bounds(const std::vector<Vec3>& all) { return Surface{all, {}}.bounds(); }

/// Water filled up to voxel layer `full` everywhere, over `frames` frames; each next frame one layer higher when
/// `rising`.
RunRecord flat_water(std::array<int, 3> count, int full, int frames, bool rising = false) {
    RunRecord r = synthetic_run({.duration = 0.2, .step = 4e-3, .frames = false});
    r.raster = {{-1.4, 0, -0.6}, 0.1, count};
    const std::size_t layer = static_cast<std::size_t>(count[0]) * static_cast<std::size_t>(count[1]);
    for (int f = 0; f < frames; ++f) {
        RasterFrame frame{0.1 + 0.01 * f, std::vector<std::uint8_t>(layer * static_cast<std::size_t>(count[2]))};
        std::fill_n(frame.water.begin(), layer * static_cast<std::size_t>(full + (rising ? f : 0)), 255);
        r.frames.push_back(std::move(frame));
    }
    return r;
}

TEST(View3d, FlatWaterLiesWhereTheRasterHasIt) {
    const Comparison c = compare_records({flat_water({40, 12, 10}, 5, 3, true)});
    const Json data = data_of(view3d_section(c));
    ASSERT_EQ(data["sources"].size(), 1u);
    const Json& source = data["sources"][0];
    ASSERT_EQ(source["points"].size(), 3u);
    for (std::size_t f = 0; f < 3; ++f) {
        const std::vector<Vec3> all = points(data, source["points"][f]);
        ASSERT_GE(all.size(), 40u * 12);
        const double level = -0.6 + 0.1 * (5.0 + static_cast<double>(f));  // of the layers that are full
        for (const Vec3& p : all) EXPECT_NEAR(p.z(), level, tolerance(data, 2));
        // From the first to the last voxel centre; the half model begins on its plane of symmetry.
        EXPECT_NEAR(bounds(all).min.x(), -1.35, tolerance(data, 0));
        EXPECT_NEAR(bounds(all).max.x(), -1.4 + 3.95, tolerance(data, 0));
        EXPECT_NEAR(bounds(all).min.y(), 0, tolerance(data, 1));
        EXPECT_NEAR(bounds(all).max.y(), 1.15, tolerance(data, 1));
        // The triangles cover exactly that rectangle.
        const std::vector<unsigned> corners = source["triangles"][f].get<std::vector<unsigned>>();
        double area = 0;
        for (std::size_t t = 0; t + 2 < corners.size(); t += 3) {
            for (std::size_t k = 0; k < 3; ++k) ASSERT_LT(corners[t + k], all.size());
            area += 0.5 * (all[corners[t + 1]] - all[corners[t]]).cross(all[corners[t + 2]] - all[corners[t]]).norm();
        }
        EXPECT_NEAR(area, 3.9 * 1.15, 2 * (1.15 * tolerance(data, 0) + 3.9 * tolerance(data, 1)));
    }
    EXPECT_TRUE(source["mirror"].get<bool>());
}

TEST(View3d, AWholeModelIsNotMirroredAndABlockOfWaterKeepsItsSides) {
    RunRecord r = flat_water({20, 11, 10}, 0, 1);
    r.attributes["symmetry_factor"] = "1";
    r.raster.origin.y() = -0.3;
    for (int k = 0; k < 10; ++k)  // a wall of water in the columns x > -0.4
        for (int j = 0; j < 11; ++j)
            for (int i = 10; i < 20; ++i) r.frames[0].water[static_cast<std::size_t>((k * 11 + j) * 20 + i)] = 255;
    const Json data = data_of(view3d_section(compare_records({r})));
    EXPECT_FALSE(data["sources"][0]["mirror"].get<bool>());
    const std::vector<Vec3> all = points(data, data["sources"][0]["points"][0]);
    ASSERT_FALSE(all.empty());
    for (const Vec3& p : all) EXPECT_NEAR(p.x(), -0.4, tolerance(data, 0));
    EXPECT_NEAR(bounds(all).min.y(), -0.25, tolerance(data, 1));
}

TEST(View3d, ATwoDimensionalRunIsASlab) {
    RunRecord r = flat_water({40, 1, 10}, 5, 2);
    r.hull = {};
    r.hull_pressure.clear();
    r.hull_wet.clear();
    const Json data = data_of(view3d_section(compare_records({r})));
    const std::vector<Vec3> all = points(data, data["sources"][0]["points"][0]);
    ASSERT_FALSE(all.empty());
    EXPECT_NEAR(bounds(all).size().y(), 0.2 * 40 * 0.1, 2 * tolerance(data, 1));
    EXPECT_NEAR(bounds(all).max.z(), -0.1, tolerance(data, 2));
    EXPECT_FALSE(data["sources"][0]["mirror"].get<bool>());
    EXPECT_TRUE(data["hulls"].empty());
}

TEST(View3d, TheHullIsThereOnceForBothMethods) {
    const Comparison c = compare_records({flat_water({40, 12, 10}, 5, 2), flat_water({40, 12, 10}, 5, 2)});
    const Json data = data_of(view3d_section(c));
    ASSERT_EQ(data["hulls"].size(), 1u);
    EXPECT_EQ(data["hulls"][0]["sources"], Json({0, 1}));
    const Surface& hull = c.sources[0].hull;
    EXPECT_EQ(data["hulls"][0]["triangles"].size(), 3 * hull.triangles.size());
    const Box box = bounds(points(data, data["hulls"][0]["points"])), exact = hull.bounds();
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(box.min[axis], exact.min[axis], tolerance(data, static_cast<std::size_t>(axis)));
        EXPECT_NEAR(box.max[axis], exact.max[axis], tolerance(data, static_cast<std::size_t>(axis)));
    }
    RunRecord other = flat_water({40, 12, 10}, 5, 2);
    other.attributes["hull_hash"] = "hull-2";
    const Json forced =
        data_of(view3d_section(compare_records({flat_water({40, 12, 10}, 5, 2), other}, {.force = true})));
    EXPECT_EQ(forced["hulls"].size(), 2u);
}

TEST(View3d, TheHullHasThePressuresOfEachMethodOnOneScale) {
    RunRecord a = flat_water({40, 12, 10}, 5, 2), b = a;
    b.attributes["method"] = "fvm";
    for (std::size_t t = 0; t < b.hull_pressure.size(); ++t) b.hull_pressure[t] *= 0.5f;
    const Comparison c = compare_records({a, b});
    const std::string html = view3d_section(c);
    EXPECT_TRUE(has(html, "pressure on the hull [kPa]"));
    EXPECT_TRUE(has(html, "<option value=\"pressure\">"));
    const Json data = data_of(html);
    EXPECT_EQ(data["pressure"]["stops"], Json(pressure_scale(0, 1).stops()));
    const auto range = pressure_range(c);
    ASSERT_TRUE(range.has_value());
    for (std::size_t s = 0; s < 2; ++s) {
        const RunRecord& r = c.sources[s];
        const auto bytes = bytes_of(data["hulls"][0]["pressures"][s]);
        ASSERT_EQ(bytes.size(), r.hull.triangles.size());
        std::size_t wet = 0;
        for (std::size_t t = 0; t < bytes.size(); ++t) {
            const auto p = wet_pressure(r, t);
            wet += p ? 1 : 0;
            if (!p) {
                EXPECT_EQ(bytes[t], 255) << "dry";
                continue;
            }
            const double width = range->high - range->low;
            EXPECT_NEAR(range->low + bytes[t] / 254.0 * width, std::clamp(*p, range->low, range->high), width / 250);
        }
        EXPECT_GT(wet, 0u);
        EXPECT_LT(wet, bytes.size());
    }
}

/// A hull of millions of triangles is drawn with fewer: each has what lies under it on its own side.
TEST(View3d, ALighterHullKeepsWherePressuresAre) {
    RunRecord r = synthetic_run({.duration = 0.1, .frames = false});
    r.hull = refined(r.hull, 0.06);
    r.hull_pressure.clear();
    r.hull_wet.clear();
    for (int t = 0; t < static_cast<int>(r.hull.triangles.size()); ++t) {
        r.hull_pressure.push_back(static_cast<float>(1000 * r.hull.corner(t, 0).x()));
        r.hull_wet.push_back(r.hull.area_vector2(t).z() < 0 ? 1.0f : 0.0f);
    }
    const Surface light = light_surface(r.hull, 2000);
    const Box box = r.hull.bounds();
    const PressureRange range{1000 * box.min.x(), 1000 * box.max.x()};
    const auto bytes = bytes_of(packed_pressures(r, r.hull, light, range));
    ASSERT_EQ(bytes.size(), light.triangles.size());
    std::size_t far = 0, wrong_side = 0;
    for (int t = 0; t < static_cast<int>(light.triangles.size()); ++t) {
        const unsigned char byte = bytes[static_cast<std::size_t>(t)];
        const double nz = light.area_vector2(t).normalized().z();
        const double x = (light.corner(t, 0).x() + light.corner(t, 1).x() + light.corner(t, 2).x()) / 3;
        if (byte == 255) {
            wrong_side += nz < -0.2 ? 1 : 0;
            continue;
        }
        wrong_side += nz > 0.2 ? 1 : 0;
        const double there = box.min.x() + byte / 254.0 * box.size().x();
        far += std::abs(there - x) > 0.15 ? 1 : 0;
    }
    EXPECT_EQ(far, 0u);
    EXPECT_EQ(wrong_side, 0u);
    EXPECT_GT(std::ranges::count(bytes, 255), 100);
}

TEST(View3d, WithoutPressuresThereIsNoChoiceOfThem) {
    RunRecord r = flat_water({40, 12, 10}, 5, 2);
    r.hull_pressure.clear();
    r.hull_wet.clear();
    const std::string html = view3d_section(compare_records({r}));
    EXPECT_TRUE(data_of(html)["pressure"].is_null());
    EXPECT_TRUE(data_of(html)["hulls"][0]["pressures"][0].is_null());
    EXPECT_FALSE(has(html, "value=\"pressure\""));
    EXPECT_FALSE(has(html, "view3d-pressure"));
    EXPECT_TRUE(has(html, "<option value=\"height\">by height</option><option value=\"method\">"));
}

/// What the script draws of a body: the packed surface, moved by the pose of one surface of water.
std::vector<Vec3> drawn(const Json& data, const Json& body, std::size_t source, std::size_t surface) {
    std::vector<Vec3> all = points(data, body["points"]);
    const std::vector<double> m = body["poses"][source][surface];
    for (Vec3& p : all)
        p = Vec3(m[0] * p.x() + m[4] * p.y() + m[8] * p.z() + m[12], m[1] * p.x() + m[5] * p.y() + m[9] * p.z() + m[13],
                 m[2] * p.x() + m[6] * p.y() + m[10] * p.z() + m[14]);
    return all;
}

/// A tank with a brick of 0.4 x 0.2 x 0.2 m that falls at `speed` and turns about y by 90 degrees in 0.1 s.
RunRecord falling_brick(double speed, int rows = 12) {
    RunRecord r = flat_water({40, rows, 10}, 5, 3);
    r.hull = {};
    r.hull_pressure.clear();
    r.hull_wet.clear();
    r.attributes["symmetry_factor"] = "1";
    r.attributes["motion"] = "none";
    if (rows == 1) r.numbers["dimensions"] = 2;
    Surface brick = make_hull("box", {{"length", 0.4}, {"beam", 0.2}, {"height", 0.2}});
    const Box box = brick.bounds();
    for (Vec3& p : brick.points) p += Vec3(1, rows == 1 ? 0 : 0.5, 0.2) - (box.min + box.max) / 2;
    r.bodies.push_back({"body_brick", brick, {1, rows == 1 ? 0 : 0.5, 0.2}});
    Table& t = r.table("body_brick");
    for (int k = 1; k <= 20; ++k) {
        const double time = 0.01 * k, angle = time / 0.1 * std::numbers::pi / 2;
        t.time.push_back(time);
        const auto put = [&](const char* name, const char* unit, double value) {
            t.column(name, unit).values.push_back(value);
        };
        put("x", "m", 1), put("y", "m", r.bodies[0].centre.y()), put("z", "m", 0.2 - speed * time);
        put("q0", "-", std::cos(angle / 2)), put("qx", "-", 0), put("qy", "-", std::sin(angle / 2)), put("qz", "-", 0);
    }
    return r;
}

TEST(View3d, BodiesStandWhereEachMethodHasThemInTheFrameThatIsShown) {
    RunRecord a = falling_brick(2), b = falling_brick(4);
    b.attributes["method"] = "fvm";
    const Json data = data_of(view3d_section(compare_records({a, b})));
    ASSERT_EQ(data["hulls"].size(), 1u) << "one body, drawn at two places";
    const Json& brick = data["hulls"][0];
    for (std::size_t s = 0; s < 2; ++s)
        for (std::size_t f = 0; f < 3; ++f) {
            const double time = data["sources"][s]["time"][f];
            const Box box = bounds(drawn(data, brick, s, f));
            EXPECT_NEAR((box.min.z() + box.max.z()) / 2, 0.2 - (s == 0 ? 2 : 4) * time, 2 * tolerance(data, 2));
            if (f == 0) { EXPECT_NEAR(box.size().z(), 0.4, 4 * tolerance(data, 0)) << "on end after a quarter turn"; }
        }
    EXPECT_FALSE(data["ship"].get<bool>());
    EXPECT_NEAR(data["cut"].get<double>(), 0.5, 1e-9) << "through the middle of the body";
}

TEST(View3d, ABodyOfTwoDimensionsIsAsWideAsItsWater) {
    const Json data = data_of(view3d_section(compare_records({falling_brick(2, 1)})));
    const Box water = bounds(points(data, data["sources"][0]["points"][0]));
    const Box body = bounds(drawn(data, data["hulls"][0], 0, 0));
    EXPECT_NEAR(body.min.y(), water.min.y(), 3 * tolerance(data, 1));
    EXPECT_NEAR(body.max.y(), water.max.y(), 3 * tolerance(data, 1));
    EXPECT_TRUE(data["cut"].is_null()) << "a slab is open at its sides";
}

TEST(View3d, AFineHullBecomesLighterAndKeepsItsShape) {
    const Surface prism = synthetic_run({.duration = 0.1, .frames = false}).hull;
    const Surface fine = refined(prism, 0.06);
    ASSERT_GT(fine.triangles.size(), 10'000u);
    const auto volume = [](const Surface& s) {
        double six = 0;
        for (int t = 0; t < static_cast<int>(s.triangles.size()); ++t)
            six += s.corner(t, 0).dot(s.corner(t, 1).cross(s.corner(t, 2)));
        return six / 6;
    };
    for (const std::size_t most : {4000u, 200u}) {
        const Surface light = light_surface(fine, most);
        EXPECT_LE(light.triangles.size(), most);
        EXPECT_GT(light.triangles.size(), most / 4);
        EXPECT_NEAR(volume(light) / volume(prism), 1, 0.01);
    }
    // Triangles that share no point become fewer all the same.
    Surface loose;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> anywhere;
    for (int t = 0; t < 3000; ++t) {
        for (int k = 0; k < 3; ++k) loose.points.emplace_back(anywhere(random), anywhere(random), anywhere(random));
        loose.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    EXPECT_LE(light_surface(loose, 1000).triangles.size(), 1000u);
    loose.points[0].x() = std::nan("");
    EXPECT_EQ(light_surface(loose, 5000).triangles.size(), 2999u);
}

TEST(View3d, FramesLieEvenlyAndTheLastIsShown) {
    RunRecord a = flat_water({20, 6, 8}, 4, 200), b = flat_water({20, 6, 8}, 4, 80);
    b.attributes["method"] = "fvm";
    const std::string html = view3d_section(compare_records({a, b}));
    const Json data = data_of(html);
    const std::vector<double> time = data["time"];
    ASSERT_EQ(time.size(), 60u);
    EXPECT_DOUBLE_EQ(time.front(), 0.1);
    EXPECT_DOUBLE_EQ(time.back(), a.frames.back().time);
    for (std::size_t k = 1; k < 60; ++k) EXPECT_NEAR(time[k] - time[k - 1], (time.back() - time.front()) / 59, 1e-12);
    for (std::size_t s = 0; s < 2; ++s) {
        const RunRecord& r = s == 0 ? a : b;
        const std::vector<double> has = data["sources"][s]["time"];
        const std::vector<std::size_t> step = data["sources"][s]["step"];
        ASSERT_EQ(step.size(), time.size());
        EXPECT_EQ(data["sources"][s]["points"].size(), has.size());
        EXPECT_DOUBLE_EQ(has.back(), r.frames.back().time);
        EXPECT_EQ(step.back(), has.size() - 1);
        for (std::size_t k = 0; k < step.size(); ++k)  // the nearest frame; after its end the last one stays
            EXPECT_NEAR(has.at(step[k]), std::min(time[k], r.frames.back().time), 0.005 + 1e-9);
    }
    EXPECT_TRUE(has(html, "SPH 60 of 200")) << between(html, "Frames shown", "</p>");
    const Json few = data_of(view3d_section(compare_records({flat_water({20, 6, 8}, 4, 3)})));
    EXPECT_EQ(few["time"].size(), 3u);
}

TEST(View3d, NamesStayText) {
    const std::string hostile = "</script><script>alert('x')</script><!-- \" onload=\"x \x1b\xff &amp;";
    RunRecord r = flat_water({20, 6, 8}, 4, 2);
    for (auto& [name, text] : r.attributes)
        if (name != "symmetry_factor" && name != "motion") text = hostile;
    const std::string html = view3d_section(compare_records({r, r}));
    EXPECT_EQ(count_of(html, "<script"), 2u);  // the data and view3d.js
    EXPECT_EQ(count_of(html, "</script"), 2u);
    EXPECT_FALSE(has(html, "alert('x')</"));
    EXPECT_FALSE(has(html, "<!--"));
    EXPECT_FALSE(has(html, "\" onload=\""));
    EXPECT_FALSE(has(html, "\x1b"));
    EXPECT_TRUE(has(html, "\\u003c/script\\u003e"));
    const std::string name = data_of(html)["sources"][0]["name"];
    EXPECT_TRUE(name.starts_with("</script><script>alert('x')</script><!-- \" onload=\"x \x1b")) << name;
}

// A page that is mailed: of frames that are alike only the first counts.
TEST(View3d, AFrameLikeTheOneBeforeTakesHardlyAnyRoom) {
    const auto bytes = [](int frames, bool rising) {
        const std::string html = view3d_section(compare_records({flat_water({60, 30, 40}, 5, frames, rising)}));
        return between(html, "id=\"view3d-data\">", "</script>").size();
    };
    const std::size_t one = bytes(1, false), thirty = bytes(30, false), rising = bytes(30, true);
    EXPECT_LT(thirty, 5 * one);
    EXPECT_LT(rising, 5 * one);
}

TEST(View3d, StaysSmallHoweverLargeTheRaster) {
    RunRecord a = flat_water({200, 100, 12}, 0, 26);
    std::mt19937 random(3);
    for (RasterFrame& f : a.frames)  // spray everywhere: nearly every voxel has a surface
        for (std::uint8_t& share : f.water) share = static_cast<std::uint8_t>(random() % 4 == 0 ? 255 : 0);
    RunRecord b = a;
    b.attributes["method"] = "fvm";
    const std::string html = view3d_section(compare_records({a, b}));
    EXPECT_LE(html.size(), view3d_most_bytes);
    EXPECT_GT(html.size(), view3d_most_bytes / 100);
    EXPECT_TRUE(has(html, " voxels per edge")) << between(html, "Frames shown", "</p>");
    const Json data = data_of(html);
    EXPECT_GE(data["time"].size(), 24u);
    for (const Json& source : data["sources"]) EXPECT_EQ(source["time"].back().get<double>(), a.frames.back().time);
}

TEST(View3d, ACoarsenedSurfaceKeepsTheLevel) {
    RunRecord r = flat_water({1200, 120, 6}, 2, 1);  // more columns than 16 bits can number
    r.hull = {};
    r.hull_pressure.clear();
    r.hull_wet.clear();
    const std::string html = view3d_section(compare_records({r}));
    EXPECT_TRUE(has(html, "blocks of 2 voxels per edge"));
    const Json data = data_of(html);
    const std::vector<Vec3> all = points(data, data["sources"][0]["points"][0]);
    ASSERT_GT(all.size(), 30'000u);
    for (const Vec3& p : all) ASSERT_NEAR(p.z(), -0.4, tolerance(data, 2));
    EXPECT_NEAR(bounds(all).max.y(), 11.9, tolerance(data, 1));
    EXPECT_NEAR(bounds(all).min.y(), 0, tolerance(data, 1));
    EXPECT_EQ(view3d_section(compare_records({r})), html);  // the same bytes again
}

/// As a policy names a script, by OpenSSL.
std::string policy_source(const std::string& script) {
    unsigned char digest[EVP_MAX_MD_SIZE], text[2 * EVP_MAX_MD_SIZE];
    unsigned length = 0;
    EVP_Digest(script.data(), script.size(), digest, &length, EVP_sha256(), nullptr);
    EVP_EncodeBlock(text, digest, static_cast<int>(length));
    return "'sha256-" + std::string(reinterpret_cast<const char*>(text)) + "'";
}

TEST(View3d, OnlyThePagesOwnScriptsMayRun) {
    const ScratchFolder folder;
    const std::string page =
        read_text(write_report(compare_records({flat_water({20, 6, 8}, 4, 2)}), folder.path()).html);
    const std::string policy = between(page, "Content-Security-Policy\" content=\"", "\">");
    const std::string nothing_else =
        "default-src 'none'; base-uri 'none'; form-action 'none'; img-src data:; style-src 'unsafe-inline'";
    const std::string plots = plots_script, view = view3d_script;
    if (plots.empty()) {  // a build without npm: the page has drawings and pictures
        EXPECT_TRUE(view.empty());
        EXPECT_EQ(policy, nothing_else);
        EXPECT_EQ(count_of(page, "<script"), 0u);
        EXPECT_FALSE(has(page, "view3d"));
        return;
    }
    EXPECT_TRUE(has(page, "<script>" + plots + "</script>"));
    EXPECT_TRUE(has(page, "<script>" + view + "</script>"));
    EXPECT_EQ(policy, nothing_else + "; script-src " + policy_source(plots) + " " + policy_source(view));
    EXPECT_EQ(count_of(page, "<script>"), 2u);  // all others are data
    EXPECT_EQ(count_of(page, "<script"), 2 + count_of(page, "<script type=\"application/json\""));
    // The libraries' licences go with them, and the two take less than 4 MB.
    for (const char* line : {"\nuplot 1.", "\nthree 0."})
        EXPECT_TRUE(has(page, "<script>/*!" + std::string(line))) << line;
    EXPECT_EQ(count_of(page, "Permission is hereby granted, free of charge"), 2u);
    EXPECT_LT(plots.size() + view.size(), 4'000'000u);
    // A reader without scripts gets a sentence, and paper gets nothing.
    EXPECT_TRUE(has(page, "<p class=\"note\" id=\"view3d-fallback\">"));
    EXPECT_TRUE(has(page, "<div id=\"view3d-stage\" hidden>"));
    EXPECT_TRUE(has(page, "@media print{.view3d{display:none}}"));
}

TEST(View3d, WithoutFramesThePageHasNoScriptOfIt) {
    const ScratchFolder folder;
    const Comparison c = compare_records({synthetic_run({.duration = 0.2, .step = 4e-3, .frames = false})});
    EXPECT_TRUE(view3d_section(c).empty());
    const std::string page = read_text(write_report(c, folder.path()).html);
    EXPECT_FALSE(has(page, "view3d-"));
    EXPECT_EQ(count_of(page, "<script>"), *plots_script ? 1u : 0u);
    EXPECT_TRUE(has(page, "default-src 'none'"));
    Comparison senseless = compare_records({flat_water({20, 6, 8}, 4, 2)});
    EXPECT_FALSE(view3d_section(senseless).empty());
    senseless.sources[0].raster.voxel = 1e308;
    EXPECT_TRUE(view3d_section(senseless).empty());
    senseless.sources[0].raster.voxel = 0.1;
    senseless.sources[0].raster.origin.x() = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(view3d_section(senseless).empty());
}

}  // namespace view3d_test
}  // namespace tw

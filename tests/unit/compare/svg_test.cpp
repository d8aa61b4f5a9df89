#include <gtest/gtest.h>
#include <openssl/evp.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "compare/report/escape.h"
#include "compare/report/colours.h"
#include "compare/report/numbers.h"
#include "compare/report/svg_plot.h"
#include "compare/report/first_screen.h"

namespace tw {
namespace svg_test {

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
    return n;
}

TEST(SvgPlot, DrawsEachLineInItsSourcesColourAndABreakAtNotANumber) {
    Plot p{.title = "t", .x_label = "x", .y_label = "y"};
    p.lines.push_back({"one", 0, {0, 1, 2, 3}, {1, 2, std::nan(""), 3}, false, false});
    p.lines.push_back({"two", 1, {0, 3}, {0, 4}, false, false});
    const std::string s = svg(p);
    EXPECT_EQ(count(s, "<path"), 2u);
    EXPECT_NE(s.find("class=\"line s1\""), std::string::npos);
    EXPECT_EQ(s.find("nan"), std::string::npos);
    const std::string first = s.substr(s.find("<path class=\"line s0\""));
    EXPECT_EQ(count(first.substr(0, first.find("/>")), "M"), 2u);
    EXPECT_EQ(count(s, "<svg"), count(s, "</svg>"));
}

TEST(SvgPlot, NothingToDrawIsSaid) {
    EXPECT_NE(svg(Plot{.title = "empty"}).find("no data"), std::string::npos);
    Plot p{.title = "t"};
    p.lines.push_back({"a", 0, {0, 1}, {std::nan(""), std::nan("")}, false, false});
    EXPECT_NE(svg(p).find("no data"), std::string::npos);
}

/// Any series ends as a plot of a few kilobytes, whose numbers are finite.
TEST(SvgPlot, OfAnySeriesIsSmallAndFinite) {
    const double nan = std::nan("");
    for (const std::vector<double>& y : {std::vector<double>{2.0000000000000804, 2.0000000000000813},
                                         {2, std::nextafter(2, 3)},
                                         {0, 5e-324},
                                         {-1.7e308, 1.7e308},
                                         {1e300, 1e300},
                                         {nan, nan},
                                         {nan, 3},
                                         {HUGE_VAL, 1},
                                         {}}) {
        for (const bool logarithmic : {false, true}) {
            Plot p{.title = "t"};
            p.log_y = logarithmic;
            PlotLine l{"a", 0, {}, y, false, false};
            for (std::size_t i = 0; i < y.size(); ++i) l.x.push_back(static_cast<double>(i));
            p.lines.push_back(l);
            const std::string drawn = svg(p);
            EXPECT_LT(drawn.size(), 20000u);
            for (const char* no_number : {"\"nan", "\"inf", "\"-inf", "\"-nan", ",nan", ",-nan", ",inf"})
                EXPECT_EQ(drawn.find(no_number), std::string::npos) << drawn;
        }
    }
}

TEST(SvgPlot, AStartUpSpikeDoesNotFlattenTheRest) {
    Plot p{.title = "t", .clip_spikes = true};
    PlotLine l{"a", 0, {}, {}, false, false};
    for (int i = 0; i < 1000; ++i) l.x.push_back(i), l.y.push_back(i == 0 ? 1e6 : 100 + i % 7);
    p.lines.push_back(l);
    EXPECT_EQ(svg(p).find(">1000000<"), std::string::npos);
    p.clip_spikes = false;
    EXPECT_NE(svg(p).find(">1000000<"), std::string::npos);
}

TEST(SvgPlot, LongSeriesAreThinnedWithoutLosingTheirExtremes) {
    Plot p{.title = "t"};
    PlotLine l{"a", 0, {}, {}, false, false};
    for (int i = 0; i < 200000; ++i) l.x.push_back(i), l.y.push_back(i == 77777 ? 5 : 0);
    p.lines.push_back(l);
    EXPECT_LT(svg(p).size(), 60000u);
    EXPECT_NE(svg(p).find(">5<"), std::string::npos);
}

/// The 32-bit floats that plots.js reads from a line of the page's data.
std::vector<float> floats(const std::string& packed) {
    std::string bytes(packed.size(), '\0');
    const int n =
        EVP_DecodeBlock(reinterpret_cast<unsigned char*>(bytes.data()),
                        reinterpret_cast<const unsigned char*>(packed.data()), static_cast<int>(packed.size()));
    const std::size_t padding = packed.ends_with("==") ? 2 : packed.ends_with("=") ? 1 : 0;
    std::vector<float> values((static_cast<std::size_t>(n) - padding) / sizeof(float));
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(float));
    return values;
}

TEST(PlotData, HoldsTheValuesWithTheirExtremesAndGaps) {
    Plot p{.title = "t"};
    PlotLine l{"</script><b>", 1, {}, {}, false, false};
    for (int i = 0; i < 200000; ++i)
        l.x.push_back(1e-3 * i), l.y.push_back(i == 77777 ? 5 : i == 100000 ? std::nan("") : std::sin(1e-3 * i));
    p.lines.push_back(l);
    p.bands.push_back({1, 10, 20, 0.5, 0.1});
    const std::string block = live_plot(p).data;
    EXPECT_LT(block.size(), 100'000u);
    EXPECT_EQ(count(block, "</script"), 1u) << "a name ends no block";
    const auto from = block.find('>') + 1;
    const auto data = nlohmann::json::parse(block.substr(from, block.rfind("</script>") - from));
    EXPECT_EQ(data["lines"][0]["name"], l.name);
    EXPECT_EQ(data["bands"][0]["half_width"], 0.1);
    const std::vector<float> x = floats(data["lines"][0]["x"]), y = floats(data["lines"][0]["y"]);
    ASSERT_EQ(x.size(), y.size());
    EXPECT_EQ(x.front(), 0);
    EXPECT_EQ(x.back(), 199.999f);
    EXPECT_EQ(std::ranges::count(y, 5.0f), 1);
    EXPECT_EQ(std::ranges::count_if(y, [](float v) { return std::isnan(v); }), 1);
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (i > 0) { EXPECT_GT(x[i], x[i - 1]); }
        if (!std::isnan(y[i]) && y[i] != 5) { EXPECT_NEAR(y[i], std::sin(x[i]), 1e-5) << x[i]; }
    }
}

TEST(PlotData, OfMapsAndOfNothingThereIsNone) {
    EXPECT_TRUE(live_plot({.title = "empty"}).data.empty());
    Plot map{.title = "map"};
    map.images.push_back({"", 0, 1, 0, 1});
    EXPECT_TRUE(live_plot(map).data.empty());
    EXPECT_TRUE(live_plot(map).svg.starts_with("<svg"));
}

TEST(Ticks, AreOneTwoFive) {
    EXPECT_EQ(ticks(0, 10, 5), (std::vector<double>{0, 2, 4, 6, 8, 10}));
    EXPECT_EQ(ticks(5, 5, 5).size(), 0u);
    EXPECT_EQ(ticks(5, HUGE_VAL, 5).size(), 0u);
    EXPECT_LT(ticks(2.0000000000000804, 2.0000000000000813, 5).size(), 8u);
    EXPECT_LT(ticks(-1.7e308, 1.7e308, 5).size(), 8u);
}

TEST(Escaping, LeavesNoMarkupAndNoBrokenBytes) {
    EXPECT_EQ(escaped("<script>alert(\"x\")</script>&'"),
              "&lt;script&gt;alert(&quot;x&quot;)&lt;/script&gt;&amp;&#39;");
    EXPECT_EQ(escaped("é–"), "é–");
    EXPECT_EQ(escaped("a\xff\x01"), "a\xEF\xBF\xBD\xEF\xBF\xBD");
    EXPECT_EQ(escaped("\xC0\xBC"), "\xEF\xBF\xBD\xEF\xBF\xBD");  // an overlong '<'
}

TEST(Svg, LogarithmicAxesHaveTheirTicksAndLeaveOutWhatHasNoLogarithm) {
    EXPECT_EQ(log_ticks(0.9, 31), (std::vector<double>{1, 2, 5, 10, 20}));
    EXPECT_EQ(log_ticks(1, 1e6).size(), 7u);
    Plot p;
    p.log_x = p.log_y = true;
    p.lines = {{"cost", 0, {1, 100, 1000}, {10, 0, 1}, false, false, true}};
    const std::string out = svg(p);
    std::size_t dots = 0;
    for (std::size_t at = out.find("<circle"); at != std::string::npos; at = out.find("<circle", at + 1)) ++dots;
    EXPECT_EQ(dots, 2u);
    EXPECT_EQ(out.find("nan"), std::string::npos);
    EXPECT_NE(out.find(">100<"), std::string::npos);
}

TEST(Base64, KnownVectors) {  // RFC 4648, section 10
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Numbers, ShowTheDigitsTheirIntervalSupports) {
    EXPECT_EQ(value_text(2722.4, 13.2), "2722 ± 13");
    EXPECT_EQ(value_text(0.41234, 0.0251), "0.412 ± 0.025");
    EXPECT_EQ(value_text(-0.00001, 0.05), "0 ± 0.050");
    EXPECT_EQ(value_text(0, 6.5), "0 ± 6.5");
    EXPECT_EQ(signed_text(0.00001, 0.05), "0 ± 0.050");
    EXPECT_EQ(signed_text(-82.3, 19), "−82 ± 19");
    EXPECT_EQ(per_cent_text(-3.02), "−3.0 %");
    EXPECT_EQ(value_text(std::nan(""), 1), "–");
}

TEST(Numbers, AreWrittenAsPeopleWriteThem) {
    EXPECT_EQ(number_text(359.90309865758275), "360");
    EXPECT_EQ(number_text(0.0625082), "0.0625");
    EXPECT_EQ(number_text(5.47e-5), "0.0000547");
    EXPECT_EQ(number_text(-1160.9, 5), "−1160.9");
    EXPECT_EQ(unit_text("m2"), "m²");
    EXPECT_EQ(unit_text("kg/m3"), "kg/m³");
    EXPECT_EQ(unit_text("m2/s"), "m²/s");
    EXPECT_EQ(unit_text("N m"), "N m");
    EXPECT_EQ(unit_text("-"), "-");
    EXPECT_EQ(unit_text("H2O"), "H2O");
    EXPECT_EQ(label_text("pressure at P2 [N/m2]"), "pressure at P2 [N/m²]");
    EXPECT_EQ(label_text("P2"), "P2");
}

TEST(Ticks, HaveNoPowersOfTenAndARealMinus) {
    EXPECT_EQ(tick_text(-1300, 100), "−1300");
    EXPECT_EQ(tick_text(-1e-15, 0.1), "0.0");
    EXPECT_EQ(tick_text(2e6, 1e6), "2000000");
    Plot p{.lines = {{"a", 0, {10, 1000, 20000}, {1, 100, 50000}, false, false}}, .log_x = true, .log_y = true};
    const std::string drawn = svg(p);
    EXPECT_EQ(drawn.find("e+0"), std::string::npos) << drawn;
    EXPECT_NE(drawn.find(">1000<"), std::string::npos);
}

TEST(Strip, DrawsTheDifferenceAboutZeroAndEveryIntervalWhole) {
    Strip strip{"Lift", {{"SPH", "100 ± 160 N", 0, 100, 160}, {"interFoam", "110 ± 5 N", 1, 110, 5}}};
    EXPECT_EQ(svg(strip).find("difference"), std::string::npos);
    const std::string without = svg(strip);
    const auto place = [](const std::string& drawn, const std::string& of, const char* what) {
        const auto line = drawn.find(of);
        const auto at = drawn.find(what, line);
        return std::stod(drawn.substr(at + std::strlen(what)));
    };
    EXPECT_GT(place(without, "class=\"bar s0\"", "x1=\""), 83) << "it does not end where the axis does";
    EXPECT_LT(place(without, "class=\"bar s0\"", "x2=\""), 449);
    strip.difference = Strip::Difference{"+9.5 ± 4 %", 10, 4.2, 5.2};
    const std::string with = svg(strip);
    EXPECT_NE(with.find("+9.5 ± 4 %"), std::string::npos);
    const double zero = place(with, "class=\"level\"", "x1=\""), low = place(with, "class=\"bar apart\"", "x1=\""),
                 band = place(with, "class=\"reference-band\"", "x=\"");
    EXPECT_GT(low, zero) << "an interval that does not hold 0 does not cross it";
    EXPECT_LT(band, zero);
}

/// A phone's is drawn again, not shrunk: the same values on a shorter axis.
TEST(Strip, HasADrawingForNarrowScreens) {
    Strip strip{"Lift", {{"SPH", "100 ± 16 N", 0, 100, 16}}};
    strip.references = {{"measured (" + std::string(80, 'x') + ")", 95, 3}};
    const std::string both = svg(strip);
    const auto narrow = both.find("<svg class=\"strip narrow\" viewBox=\"0 0 376 ");
    ASSERT_NE(narrow, std::string::npos) << both;
    EXPECT_NE(both.find("class=\"reference\"", narrow), std::string::npos);
    EXPECT_NE(both.find("100 ± 16 N</text>", narrow), std::string::npos);
    EXPECT_EQ(both.find("xxx)</text>", narrow), std::string::npos) << "no room for names";
    EXPECT_NE(both.find("xxx)</text>"), std::string::npos);
}

TEST(Colours, EndsAndMiddle) {
    const ColourScale s = elevation_scale(1, 0);
    EXPECT_EQ(s(-5), s(-1));
    EXPECT_EQ(s(5), s(1));
    EXPECT_GT(s(0)[0], s(-1)[0]);  // pale in the middle
    EXPECT_GT(s(0)[2], s(1)[2]);
}

}  // namespace svg_test
}  // namespace tw

#include "text/section.h"

#include <gtest/gtest.h>

#include "base/errors.h"

namespace tw {
namespace section_test {

/// What is complained about when `read` takes the document.
template <class Read>
std::string complaint(const std::string& text, Read read) {
    try {
        const TextValue document = parse_document(text, "a.toml");
        Section root("a.toml", "", &document);
        read(root);
    } catch (const InputError& e) { return e.what(); }
    return "sound";
}

/// Each dot makes a table within a table, which are walked by recursion: 15 000 of them ended the program.
TEST(Document, OfSenselessDepthOrNumberOfTablesIsRefusedByLine) {
    const auto of = [](const std::string& text) { return complaint(text, [](Section&) {}); };
    std::string deep = "a";
    for (int k = 0; k < 15000; ++k) deep += ".a";
    for (const std::string& text : {"\n\n" + deep + " = 1\n", "\n\n[" + deep + "]\n", "\n\nx = { " + deep + " = 1 }\n"})
        EXPECT_EQ(of(text).find("a.toml:3: a key of more than 8 parts"), 0u) << of(text).substr(0, 100);
    EXPECT_EQ(of("a.b.c = 1.5\n[d.e]\nf = [1.5, 2.5, 3.5, 4.5, 5.5, 6.5, 7.5, 8.5, 9.5]\n"), "sound");
    EXPECT_EQ(of("a = \"1.2.3.4.5.6.7.8.9.10\" # 1.2.3.4.5.6.7.8.9.10\nb = '1.2.3.4.5.6.7.8.9'\n"
                 "c = \"\"\"1.2.3.4.5\n.6.7.8.9.\\\"\"\"\"\n"),
              "sound")
        << "dots in texts and comments";
    std::string many;
    for (int k = 0; k < 10001; ++k) many += "[[probe]]\nx = 1\n";
    EXPECT_EQ(of(many).find("a.toml:20001: more than 10000 tables"), 0u);
    many = "probe = [";
    for (int k = 0; k < 10001; ++k) many += "{x = 1}, ";
    EXPECT_EQ(of(many + "]\n").find("a.toml:1: more than 10000 tables"), 0u);
}

TEST(Section, ValuesAreSIWhateverTheirUnit) {
    const TextValue document = parse_document(
        "[air]\nspeed = \"36 km/h\"\nway = [1, \"2 cm\", 3]\nheat = [\"1 m\", 2]\n[[part]]\nname = \"a\"\n"
        "[[part]]\nname = \"b\"\n",
        "a.toml");
    Section root("a.toml", "", &document), air = root.section("air"), absent = root.section("water");
    EXPECT_DOUBLE_EQ(air.number("speed", "m/s").value(), 10);
    EXPECT_EQ(air.vector("way", "m").value(), Vec3(1, 0.02, 3));
    EXPECT_EQ(air.range("heat", "m").value(), std::pair(1.0, 2.0));
    EXPECT_EQ(air.number("more", 5, "s"), 5) << "what is not written has its fallback";
    EXPECT_FALSE(absent.present());
    EXPECT_EQ(absent.text("name", "none"), "none");
    std::vector<Section> parts = root.sections("part");
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_EQ(parts[1].text("name", ""), "b");
    EXPECT_NO_THROW((air.finish(), root.finish()));
}

TEST(Section, ComplaintsNameThePlaceWhatWasFoundAndWhatIsExpected) {
    const auto air = [](auto read) {
        return [read](Section& root) {
            Section s = root.section("air");
            read(s);
        };
    };
    EXPECT_EQ(
        complaint("[air]\nspeed = \"3 kg\"\n", air([](Section& s) { s.number("speed", "m/s"); })),
        "a.toml:2:9: [air] speed = \"3 kg\": 'kg' does not measure the right thing; expected a unit like m/s, kn, "
        "kt, mph");
    EXPECT_EQ(complaint("[air]\nshare = 2\n", air([](Section& s) {
                            s.number("share", "-", Range{0, 1});
                        })),
              "a.toml:2:9: [air] share = 2: out of range; expected from 0 to 1");
    for (const char* speed : {"1e+300", "\"1e19 m/s\"", "-1e+19"})
        EXPECT_EQ(
            complaint(std::string("[air]\nspeed = ") + speed + "\n", air([](Section& s) { s.number("speed", "m/s"); })),
            std::string("a.toml:2:9: [air] speed = ") + speed + ": too large; expected at most 1e+18 m/s in size");
    EXPECT_EQ(complaint("[air]\nspeed = 1e-300\n", air([](Section& s) { s.number("speed", "m/s"); })),
              "a.toml:2:9: [air] speed = 1e-300: too small; expected at least 1e-18 m/s in size, or 0 where the key "
              "takes it");
    EXPECT_EQ(complaint("[air]\nlaw = \"roof\"\n", air([](Section& s) {
                            s.choice("law", "root", {"root", "study"});
                        })),
              "a.toml:2:7: [air] law = \"roof\": not known; expected one of: root, study; did you mean 'root'?");
    EXPECT_EQ(complaint("[air]\n\nsped = 1\n", air([](Section& s) {
                            s.number("speed", "m/s");
                            s.finish();
                        })),
              "a.toml:3:1: [air] sped = 1: unknown key; this section knows: speed; did you mean 'speed'?");
    EXPECT_EQ(complaint("[air]\n[aer]\n",
                        [](Section& root) {
                            root.section("air");
                            root.finish();
                        }),
              "a.toml:2:2: [aer]: unknown section or key; the file knows: air; did you mean 'air'?");
    EXPECT_EQ(complaint("air = 1\n", [](Section& root) { root.section("air"); }),
              "a.toml:1:7: air = 1: expected a section [air]");
    EXPECT_EQ(complaint("[part]\nx = 1\n", [](Section& root) { root.sections("part"); }),
              "a.toml:1:1: part = {...}: expected sections [[part]]");
}

}  // namespace section_test
}  // namespace tw

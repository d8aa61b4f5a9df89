#include "suite/suite.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "base/errors.h"
#include "suite/formulas.h"
#include "test_paths.h"

namespace tw {
namespace suite_test {

namespace fs = std::filesystem;

const std::string head = "name = \"tank\"\nwhy = \"Because.\"\nscene = \"tank.toml\"\n";
const std::string one =
    "[[case.quantity]]\nname = \"lift\"\nunit = \"N\"\ntruth = \"2 kN\"\nsource = \"weighed\"\ngoal = \"2 %\"\n";

/// A folder in which a suite is written.
class Suites : public testing::Test {
protected:
    fs::path folder = fs::temp_directory_path() / ("suite_test_" + std::to_string(::getpid()));

    void SetUp() override { fs::create_directories(folder / "cases"); }
    void TearDown() override { fs::remove_all(folder); }
    void write(const std::string& name, const std::string& text) const { std::ofstream(folder / name) << text; }
    Suite suite(const std::string& text) const {
        write("suite.toml", text);
        return read_suite(folder);
    }
    SuiteQuantity quantity(const std::string& text) const {
        return suite("[[case]]\n" + head + text).cases[0].quantities[0];
    }
    std::string refusal(const std::string& text) const {
        try {
            suite(text);
        } catch (const InputError& e) { return e.what(); }
        return "nothing was refused";
    }
};

TEST_F(Suites, ACaseInTenLines) {
    const Suite s = suite("title = \"Mine\"\n[[case]]\n" + head +
                          "changes = { scale = 2, trim = \"2 deg\" }\nuncertain = { speed = \"0.1 m/s\" }\n" + one);
    ASSERT_EQ(s.cases.size(), 1u);
    const SuiteCase& c = s.cases[0];
    EXPECT_EQ(c.tier, "minutes");
    EXPECT_EQ(c.scenes[0].file, folder / "tank.toml");
    EXPECT_DOUBLE_EQ(*c.scenes[0].changes.scale_resolution, 2);
    EXPECT_NEAR(*c.scenes[0].changes.trim, 2 * degree, 1e-12);
    ASSERT_TRUE(c.scenes[0].uncertain);
    EXPECT_EQ(c.scenes[0].uncertain->table.find("speed")->text, "0.1 m/s");
    const SuiteQuantity& q = c.quantities[0];
    EXPECT_DOUBLE_EQ(q.judged.truth.value, 2000);
    EXPECT_DOUBLE_EQ(q.judged.goal, 40);
    EXPECT_EQ(q.judged.truth.standing, "exact");
}

TEST_F(Suites, CasesInFilesOfTheirOwnAndSeveralScenes) {
    write("cases/b.toml", "why = \"B.\"\nscene = \"b.toml\"\n" + std::string(one).replace(2, 5, ""));
    write("cases/a.toml",
          "why = \"A.\"\n[[scene]]\nname = \"plate\"\nfile = \"p.toml\"\nmethods = [\"sph\"]\n[[scene]]\nname = "
          "\"wedge\"\nfile = \"../w.toml\"\n[[quantity]]\nname = \"x\"\nunit = \"m/s\"\nscene = \"wedge\"\ntruth = "
          "1\nsource = \"s\"\ngoal = 0.1\nreading = { table = \"body_w\", column = \"vz\", kind = \"at\", at = \"20 "
          "ms\" }\n");
    const Suite s = suite("title = \"Mine\"\n");
    ASSERT_EQ(s.cases.size(), 2u);
    EXPECT_EQ(s.cases[0].name, "a");
    EXPECT_EQ(s.cases[0].scenes[1].file, folder / "w.toml");
    EXPECT_EQ(s.cases[0].quantities[0].scene, 1u);
    EXPECT_DOUBLE_EQ(s.cases[0].quantities[0].reading->at, 0.02);
    EXPECT_DOUBLE_EQ(s.cases[0].quantities[0].judged.goal, 0.1);
}

TEST_F(Suites, TruthsByFormulaTableAndRecord) {
    const std::string q = "[[case.quantity]]\nname = \"p\"\nsource = \"s\"\ngoal = \"10 %\"\n";
    const SuiteQuantity formula = quantity(q +
                                           "unit = \"Pa\"\nformula = \"hydrostatic_pressure\"\nparameters = { depth = "
                                           "\"50 cm\" }\nfactor = -1\noffset = 5\n");
    EXPECT_NEAR(formula.judged.truth.value, -1000 * 9.81 * 0.5 + 5, 1e-9);
    write("t.csv", "who,t,x\na,0,1\na,1,3\nb,0,10\nb,2,20\n");
    const std::string csv = q + "unit = \"m\"\ncsv = \"t.csv\"\ncolumn = \"x\"\nuncertainty = \"5 %\"\n";
    const SuiteQuantity cell = quantity(csv + "row = { who = \"b\", t = 2 }\n");
    EXPECT_DOUBLE_EQ(cell.judged.truth.value, 20);
    EXPECT_DOUBLE_EQ(cell.judged.truth.half_width, 1);
    EXPECT_EQ(cell.judged.truth.standing, "measured");
    EXPECT_DOUBLE_EQ(quantity(csv + "row = { who = \"b\" }\nalong = \"t\"\nat = 0.5\n").judged.truth.value, 12.5);
    const SuiteQuantity record = quantity(q + "unit = \"Pa\"\nrecord = \"map.toml\"\nuncertainty = \"5 %\"\n");
    EXPECT_EQ(record.measured, folder / "map.toml");
    EXPECT_DOUBLE_EQ(*record.goal_share, 0.1);
    EXPECT_DOUBLE_EQ(record.judged.truth.half_width, -0.05);  // of what is not known yet
}

TEST_F(Suites, WhatIsWrongIsSaidWithItsPlace) {
    write("t.csv", "t,x\n0,1\n1,\n");
    const std::string with_case = "[[case]]\n" + head,
                      q = "[[case.quantity]]\nname = \"p\"\nunit = \"m\"\nsource = \"s\"\ngoal = \"10 %\"\n";
    const auto quantity_says = [&](const std::string& text, const std::string& words) {
        const std::string said = refusal(with_case + q + text);
        EXPECT_NE(said.find(words), std::string::npos) << said;
        EXPECT_NE(said.find("suite.toml:"), std::string::npos) << said;
    };
    quantity_says("", "expected exactly one of truth, formula, csv and record");
    quantity_says("truth = 1\ncsv = \"t.csv\"\n", "expected exactly one of");
    quantity_says("truth = \"1 s\"\n", "s");
    quantity_says("truth = 0\n", "per cent of a truth of 0");
    quantity_says("formula = \"free_fal\"\n", "did you mean 'free_fall'?");
    quantity_says("formula = \"free_fall\"\n", "missing; free_fall needs it [s]");
    quantity_says("formula = \"buoyancy\"\nparameters = { volume = 1 }\n", "is in N, and the quantity's unit is m");
    quantity_says("formula = \"free_fall\"\nparameters = { time = 1, tim = 2 }\n", "tim");
    quantity_says("csv = \"t.csv\"\ncolumn = \"x\"\n", "2 rows are meant");
    quantity_says("csv = \"t.csv\"\ncolumn = \"x\"\nrow = { t = 1 }\n", "t.csv:3: the cell holds no number");
    quantity_says("csv = \"t.csv\"\ncolumn = \"x\"\nalong = \"t\"\n", "both along (a column) and at");
    quantity_says("csv = \"t.csv\"\n", "expected one of: \"t\", \"x\"");
    quantity_says("truth = 1\nstanding = \"sure\"\n", "expected one of: exact, measured, digitised, derived");
    quantity_says("truth = 1\ntrut = 2\n", "did you mean 'truth'?");
    quantity_says("truth = 1\nuncertainty = -1\n", "out of range");
    quantity_says("truth = 1\nunit_ = \"m\"\n", "unit_");
    quantity_says("truth = 1\nscene = \"other\"\n", "no [[scene]] of this name");
    quantity_says("truth = 1\nreading = { table = \"height\", column = \"a\", kind = \"at\" }\n",
                  "a time for kind = \"at\"");
    quantity_says("truth = 1\nreading = { table = \"height\", column = \"a\", kind = \"first\" }\n",
                  "expected one of: mean");
    quantity_says("truth = 1\nknown_miss = { sph = 1 }\n", "expected a text in quotes");
    for (const auto& [text, words] :
         {std::pair{std::string("title = \"t\"\n"), "without a case"},
          std::pair{with_case, "expected one [[quantity]] or more"},
          std::pair{"[[case]]\n" + one, "expected a name of letters"},
          std::pair{with_case + one + with_case + one, "a second case is called \"tank\""},
          std::pair{"[[case]]\nname = \"a\"\nscene = \"a\"\n" + one, "expected a sentence why the case matters"},
          std::pair{with_case + "tier = \"week\"\n" + one, "expected one of: minutes, hour, night, gpu"},
          std::pair{with_case + "changes = { scal = 2 }\n" + one, "did you mean 'scale'?"},
          std::pair{with_case + "methods = [\"lbm\"]\n" + one, "\"lbm\" is not known"},
          std::pair{std::string("title = \n"), "suite.toml:1"}}) {
        const std::string said = refusal(text);
        EXPECT_NE(said.find(words), std::string::npos) << said;
        EXPECT_NE(said.find("suite.toml"), std::string::npos) << said;
    }
    EXPECT_THROW(read_suite(folder / "none"), InputError);
}

// What is missing without a misspelt key is not what is wrong.
TEST_F(Suites, AMisspeltKeyIsNamedWithItsPlaceAndTheNearestOne) {
    const std::string required = "[[case.quantity]]\nname = \"p\"\nunit = \"m\"\nsource = \"s\"\ntruth = 1\ngoal = 1\n";
    const auto misspelt = [&](const std::string& text, const std::string& key, const std::string& as,
                              const std::string& place) {
        std::string wrong = text;
        wrong.replace(wrong.find("\n" + key + " =") + 1, key.size(), as);
        const std::string said = refusal(wrong);
        EXPECT_NE(said.find("suite.toml:" + place), std::string::npos) << said;
        EXPECT_NE(said.find(as), std::string::npos) << said;
        EXPECT_NE(said.find("did you mean '" + key + "'?"), std::string::npos) << said;
    };
    const std::string all = "[[case]]\n" + head + required;
    misspelt(all, "why", "whi", "3:1: [[case]] whi = ");
    misspelt(all, "scene", "scen", "4:1: [[case]] scen = ");
    misspelt(all, "unit", "units", "7:1: [[quantity]] units = ");
    misspelt(all, "source", "sorce", "8:1: [[quantity]] sorce = ");
    misspelt(all, "truth", "trut", "9:1: [[quantity]] trut = ");
    misspelt(all, "goal", "gaol", "10:1: [[quantity]] gaol = ");
    const std::string reading = all + "[case.quantity.reading]\ntable = \"t\"\ncolumn = \"c\"\n";
    misspelt(reading, "table", "tabel", "12:1: [reading] tabel = ");
    misspelt(reading, "column", "colum", "13:1: [reading] colum = ");
    const std::string formula = "[[case]]\n" + head +
                                "[[case.quantity]]\nname = \"p\"\nunit = \"m\"\ngoal = 1\nformula = \"free_fall\"\n"
                                "[case.quantity.parameters]\ntime = 1\n";
    misspelt(formula, "formula", "formul", "9:1: [[quantity]] formul = ");
    misspelt(formula, "time", "tim", "11:1: [parameters] tim = ");
    const std::string several =
        "[[case]]\nname = \"a\"\nwhy = \"w\"\n[[case.scene]]\nname = \"b\"\nfile = \"b.toml\"\n";
    misspelt(several + required, "file", "fil", "6:1: [[scene]] fil = ");
    EXPECT_NE(refusal("titel = \"t\"\n").find("suite.toml:1:1: titel = "), std::string::npos);
    write("cases/c.toml",
          "why = \"c\"\nscene = \"c.toml\"\n[[quantity]]\nname = \"p\"\nunit = \"m\"\nsource = \"s\"\ntruth = 1\naim = "
          "1\n");
    const std::string said = refusal("title = \"t\"\n");  // nothing is near, and still it is the key that is unknown
    EXPECT_NE(said.find("c.toml:8:1: [[quantity]] aim = 1: unknown key; this section knows: along"), std::string::npos)
        << said;
    fs::remove(folder / "cases/c.toml");
}

TEST(Formulas, ByHand) {
    const auto of = [](const char* name, std::vector<double> p) { return find_formula(name)->value(p); };
    EXPECT_DOUBLE_EQ(of("hydrostatic_pressure", {1000, 9.81, 2}), 19620);
    EXPECT_DOUBLE_EQ(of("buoyancy", {1000, 10, 0.5}), 5000);
    EXPECT_DOUBLE_EQ(of("stagnation_pressure", {1000, 3}), 4500);
    EXPECT_NEAR(of("jet_force", {1000, 2, 0.1, pi}), 800, 1e-9);
    EXPECT_NEAR(of("standing_wave_period", {9.81, 1, 0.5, 1}), 1.181815523,
                1e-8);  // tests/data: standing_wave_frequencies
    EXPECT_DOUBLE_EQ(of("free_fall", {10, 2}), 20);
    EXPECT_NEAR(of("way_in_water", {9.81, 0.15, 2, 1}), 0.0367875, 1e-9);
    EXPECT_DOUBLE_EQ(of("ritter_front", {10, 0.1, 2}), 4);
    // Froude number 2.5: studies/hydraulic_jump.toml, h2 / h1 = 3.071
    EXPECT_NEAR(of("conjugate_depth", {9.81, 0.05, 1.751}), 0.15355, 1e-5);
    EXPECT_DOUBLE_EQ(of("conjugate_depth", {10, 0.1, 1}), 0.1);  // Froude number 1: no jump
    EXPECT_GT(of("savitsky_lift", {1000, 9.81, 1, 20 * degree, 5 * degree, 0.2, 8}), 1000);
    for (const TruthFormula& f : truth_formulas())
        EXPECT_NE(formulas_text().find("  " + f.name + " [" + f.unit + "]"), std::string::npos);
}

TEST(OwnSuite, ReadsAndEveryCaseSaysWhereItsTruthIsFrom) {
    const Suite own = read_suite(fs::path(TWINWAKE_SOURCE) / "validation");
    EXPECT_GE(own.cases.size(), 22u);
    for (const SuiteCase& c : own.cases) {
        for (const SuiteScene& scene : c.scenes) EXPECT_TRUE(fs::exists(scene.file)) << scene.file;
        for (const SuiteQuantity& q : c.quantities) {
            EXPECT_FALSE(q.judged.truth.source.empty()) << c.name;
            EXPECT_TRUE(q.measured.empty() ? std::isfinite(q.judged.truth.value) : fs::exists(q.measured)) << c.name;
        }
    }
}

}  // namespace suite_test
}  // namespace tw

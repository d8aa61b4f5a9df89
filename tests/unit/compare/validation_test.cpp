#include "compare/truth/validation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "compare/truth/reading.h"
#include "compare/truth/validation_report.h"
#include "test_paths.h"

namespace tw {
namespace validation_test {

namespace fs = std::filesystem;

ValidatedQuantity quantity(double truth, double U_D, double goal) {
    ValidatedQuantity q;
    q.name = "lift", q.label = "Lift <&>", q.unit = "N";
    q.truth = {truth, U_D, "exact", "by hand"};
    q.goal = goal, q.scale = std::abs(truth);
    return q;
}

ValidatedValue judged(const ValidatedQuantity& q, double value, double statistical, double discretisation,
                      double choices = 0, double input = 0) {
    ValidatedValue v;
    v.method = "sph", v.outcome = Outcome::failed;
    v.value = value, v.statistical = statistical, v.discretisation = discretisation, v.choices = choices,
    v.input = input;
    judge_against(v, q);
    return v;
}

TEST(Validation, IsAsmeVV20ByHand) {
    // E = 103 - 100; U_num^2 = 1 + 4 + 4 = 9; U_val^2 = 9 + 16 + 144 = 169
    const ValidatedQuantity q = quantity(100, 12, 20);
    const ValidatedValue v = judged(q, 103, 1, 2, 2, 4);
    EXPECT_DOUBLE_EQ(v.E, 3);
    EXPECT_DOUBLE_EQ(v.U_num, 3);
    EXPECT_DOUBLE_EQ(v.U_val, 13);
    EXPECT_EQ(v.outcome, Outcome::met);
}

TEST(Validation, EveryOutcomeByItsRule) {
    EXPECT_EQ(judged(quantity(100, 0, 5), 103, 0, 4).outcome, Outcome::met);
    EXPECT_EQ(judged(quantity(100, 0, 5), 103, 0, 6).outcome, Outcome::undecided);
    EXPECT_EQ(judged(quantity(100, 0, 5), 103, 0, 2).outcome, Outcome::near);
    EXPECT_EQ(judged(quantity(100, 0, 2), 103, 0, 1).outcome, Outcome::missed);
    EXPECT_EQ(judged(quantity(100, 0, 2), 97, 0, 1).outcome, Outcome::missed);  // below as well
    EXPECT_EQ(judged(quantity(100, 0, 5), 103, 0, nan).outcome, Outcome::not_converged);
    EXPECT_EQ(judged(quantity(100, 0, 5), nan, 0, 1).outcome, Outcome::failed);
    EXPECT_EQ(judged(quantity(100, 0, 5), 103, infinite, nan).outcome, Outcome::not_converged);
    EXPECT_FALSE(falls_short(judged(quantity(100, 0, 5), 103, 0, nan), quantity(100, 0, 5)));
    EXPECT_TRUE(falls_short(judged(quantity(100, 0, 5), 110, 0, nan), quantity(100, 0, 5)));
    EXPECT_FALSE(falls_short(judged(quantity(100, 0, 5), 103, 0, 6), quantity(100, 0, 5)));
}

/// Two families: of the three values that have an interval one holds the truth, and with the outer one two.
ValidationReport small_report() {
    ValidationReport r{"A suite", "minutes", "1.0", "a machine", "2026-01-01", "twinwake validate suite", {}};
    ValidatedCase a{"tank", "Tank | one", "tanks", "minutes", "Because.", "", "", {"tank.toml"}, "", {}, {}};
    ValidatedQuantity holds = quantity(100, 0, 5), outer = quantity(100, 0, 5), missed = quantity(100, 0, 1);
    holds.name = "holds", outer.name = "outer", missed.name = "missed";
    holds.values.push_back(judged(holds, 103, 0, 4));
    outer.values.push_back(judged(outer, 108, 0, 20));
    ValidatedValue narrow = judged(outer, 108, 0, 2);
    narrow.method = "fvm", narrow.outer_below = 9, narrow.outer_above = 2;
    outer.values.push_back(narrow);
    a.quantities = {holds, outer};
    a.costs = {{"sph", 10, 12, 3}, {"fvm", 30, 32, 3}};
    ValidatedCase b{"wave", "Wave", "waves", "minutes", "Because.", "", "", {"wave.toml"}, "", {}, {}};
    missed.values.push_back(judged(missed, 104, 0, 1));
    b.quantities = {missed};
    ValidatedCase c{"night", "Night", "waves", "night", "Because.", "", "", {"night.toml"}, "of tier night", {}, {}};
    c.quantities = {quantity(1, 0, 1)};
    c.quantities[0].values.emplace_back().method = "sph";
    r.cases = {a, b, c};
    return r;
}

TEST(Validation, SumsUpByFamilyAndMethod) {
    const std::vector<FamilySummary> all = summaries_of(small_report());
    ASSERT_EQ(all.size(), 5u);  // all: sph, fvm; tanks: sph, fvm; waves: sph
    EXPECT_EQ(all[0].method, "sph");
    EXPECT_EQ(all[0].values, 3);
    EXPECT_EQ(all[0].inner, 2);
    EXPECT_EQ(all[0].narrow, 2);        // 4 of 103, 1 of 104; 20 of 108 is wide
    EXPECT_EQ(all[0].narrow_inner, 1);  // the first
    EXPECT_EQ(all[0].met, 1);
    EXPECT_EQ(all[0].fall_short, 1);
    EXPECT_DOUBLE_EQ(all[0].median_error, 4);  // of 3, 4 and 8 %
    EXPECT_EQ(all[1].inner, 0);
    EXPECT_EQ(all[1].outer, 1);  // the truth lies 8 below, and the outer interval reaches 9 below
    EXPECT_DOUBLE_EQ(all[3].core_seconds, 30);
    EXPECT_EQ(all[4].family, "waves");
}

TEST(Validation, NamesWhatBecameWorse) {
    const ValidationReport before = small_report();
    ValidationReport now = before;
    EXPECT_TRUE(changes_between(before, now).empty());
    ValidatedQuantity& q = now.cases[0].quantities[0];
    q.values[0] = judged(q, 109, 0, 1);
    ValidatedQuantity& better = now.cases[1].quantities[0];
    better.values[0] = judged(better, 100.2, 0, 1);
    now.cases[0].quantities[1].values.pop_back();
    const std::vector<ValidationChange> changes = changes_between(before, now);
    ASSERT_EQ(changes.size(), 3u);
    EXPECT_EQ(changes[0].kind, ValidationChange::Kind::worse);
    EXPECT_EQ(changes[0].what, "tank, Lift <&>, SPH");
    EXPECT_NE(changes[0].is.find("missed"), std::string::npos) << changes[0].is;
    EXPECT_EQ(changes[1].kind, ValidationChange::Kind::better);
    EXPECT_EQ(changes[2].kind, ValidationChange::Kind::gone);
    q.values[0] = judged(q, 103.5, 0, 4);  // less than a quarter of the goal farther away
    EXPECT_EQ(changes_between(before, now)[0].kind, ValidationChange::Kind::better);
}

/// Values at three sizes whose changes grow.
ValidatedValue diverging(double finest, double middle, double coarsest) {
    ValidatedValue v;
    v.method = "sph", v.outcome = Outcome::failed;
    v.value = finest, v.statistical = v.choices = 0, v.convergence = "divergent";
    v.sizes = {{1, finest}, {1.5, middle}, {2, coarsest}};
    return v;
}

// The level behind a bump of 200 mm of water moves by 0.1, then by 0.7 mm; 4 mm are the goal.
TEST(Validation, ChangesThatGrowAndAreSmallBesideTheGoalHaveThreeTimesTheirRangeForAnInterval) {
    ValidatedQuantity q = quantity(0, 0, 4e-3);
    const auto outcome = [&](ValidatedValue v) {
        bound_by_spread(v, q);
        judge_against(v, q);
        return v;
    };
    const ValidatedValue small = outcome(diverging(-0.45e-3, -1.17e-3, -1.28e-3));
    EXPECT_NEAR(small.discretisation, 3 * 0.83e-3, 1e-12);
    EXPECT_EQ(small.outcome, Outcome::met);
    EXPECT_EQ(small.convergence, small_changes);
    const ValidatedValue large = outcome(diverging(-0.45e-3, -1.87e-3, -2.08e-3));  // three times 1.63 mm
    EXPECT_EQ(large.outcome, Outcome::not_converged);
    EXPECT_TRUE(std::isnan(large.discretisation));
    ValidatedValue known = diverging(-0.45e-3, -1.17e-3, -1.28e-3);
    known.own_discretisation = known.discretisation = 2e-3;  // an interval that there is stays
    EXPECT_DOUBLE_EQ(outcome(known).discretisation, 2e-3);

    ValidationReport r = small_report();
    r.cases[1].quantities = {q};
    r.cases[1].quantities[0].values = {small};
    judge_by(r, "gci");
    EXPECT_EQ(r.cases[1].quantities[0].values[0].outcome, Outcome::not_converged)
        << "the literature's have no such rule";
    judge_by(r, "trend_and_noise");
    EXPECT_EQ(r.cases[1].quantities[0].values[0].outcome, Outcome::met);
    EXPECT_NE(validation_pages(r)[2].text.find("three times the range"), std::string::npos);
}

TEST(Validation, WhatIsNotRunIsKeptOfAnEarlierReportAndSaysSo) {
    ValidationReport earlier = small_report();
    for (ValidatedCase& c : earlier.cases)
        for (ValidatedQuantity& q : c.quantities)
            for (ValidatedValue& v : q.values) {
                v.version = "0.9 (abcdef)", v.date = "2025-12-31";
                v.own_discretisation = v.discretisation;
            }
    ValidationReport now = small_report();
    ValidatedCase &tank = now.cases[0], &wave = now.cases[1];
    tank.quantities[1].values.pop_back();  // of both methods only SPH is run
    tank.costs.pop_back();
    wave.why_not = "not asked for", wave.quantities[0].label = wave.quantities[0].name;
    wave.quantities[0].truth.value = 101;
    wave.quantities[0].values.clear();
    for (const char* method : {"sph", "fvm"}) wave.quantities[0].values.emplace_back().method = method;
    keep_values(now, earlier);
    ASSERT_EQ(tank.quantities[1].values.size(), 2u);
    EXPECT_FALSE(tank.quantities[1].values[0].kept) << "what was run stays";
    EXPECT_TRUE(tank.quantities[1].values[1].kept);
    ASSERT_EQ(tank.costs.size(), 2u);
    ASSERT_EQ(wave.quantities[0].values.size(), 1u) << "the mesh has no value in the earlier report: not of this scene";
    const ValidatedValue& kept = wave.quantities[0].values[0];
    EXPECT_TRUE(kept.kept);
    EXPECT_DOUBLE_EQ(kept.E, 3) << "judged by the truth of now";
    EXPECT_EQ(wave.why_not, "");
    EXPECT_EQ(now.cases[2].quantities[0].values[0].outcome, Outcome::not_run) << "nobody has it";
    EXPECT_EQ(now.cases[2].why_not, "of tier night");
    for (const std::size_t page : {1u, 2u})
        EXPECT_NE(validation_pages(now)[page].text.find("0.9 (abcdef), 2025-12-31, kept"), std::string::npos)
            << validation_pages(now)[page].text;
    EXPECT_NE(validation_pages(now)[0].text.find("abcdef, kept"), std::string::npos);
    EXPECT_NE(validation_csv(now).find("0.9 (abcdef),2025-12-31,kept"), std::string::npos);
    EXPECT_NE(validation_junit(now).find("not run anew, kept of 0.9 (abcdef)"), std::string::npos);
    EXPECT_NE(validation_html(now, {}, "").find("abcdef, kept"), std::string::npos);
}

/// The report with what other methods make of the sizes of its first two values, and a part of one's input.
ValidationReport report_by_methods() {
    ValidationReport r = small_report();
    ValidatedValue &a = r.cases[0].quantities[0].values[0], &b = r.cases[0].quantities[1].values[0];
    const auto three = [](double own, double eca, double gci) {
        std::vector<MethodEstimate> all{{"trend_and_noise", 4, nan, Convergence::monotone, 99, own, ""},
                                        {"eca_hoekstra", 4, 1.5, Convergence::monotone, 98, eca, ""},
                                        {"gci", 3, 1.2, Convergence::monotone, 97, gci, ""}};
        for (MethodEstimate& m : all)
            if (std::isnan(m.uncertainty)) m.why_not = "needs four sizes";
        return all;
    };
    a.by_method = three(4, 2, 6), a.own_discretisation = 4;
    b.by_method = three(20, nan, 9), b.own_discretisation = 20;
    a.input = 5, a.inputs = {{"hull.draft", 4}, {"hull.trim", 3}};
    judge_against(a, r.cases[0].quantities[0]);
    return r;
}

TEST(Validation, IsJudgedByAnotherMethodForTheDiscretisationErrorAndBack) {
    ValidationReport r = report_by_methods();
    const ValidatedValue &a = r.cases[0].quantities[0].values[0], &b = r.cases[0].quantities[1].values[0];
    const std::string own = validation_json(r);
    judge_by(r, "gci");
    EXPECT_DOUBLE_EQ(a.U_num, 6);
    EXPECT_DOUBLE_EQ(a.U_val, std::sqrt(36.0 + 25.0));  // the input's share stays
    EXPECT_DOUBLE_EQ(a.order, 1.2);
    EXPECT_DOUBLE_EQ(b.U_num, 9);
    EXPECT_NE(validation_html(r, {}, "").find("discretisation error by GCI"), std::string::npos);
    judge_by(r, "eca_hoekstra");
    EXPECT_DOUBLE_EQ(a.U_num, 2);
    EXPECT_EQ(b.outcome, Outcome::not_converged);
    EXPECT_EQ(b.why_not, "needs four sizes");
    judge_by(r, "trend_and_noise");
    EXPECT_DOUBLE_EQ(a.U_num, 4);
    EXPECT_DOUBLE_EQ(b.U_num, 20);
    EXPECT_EQ(r.estimator, "");
    EXPECT_NE(own.find("\"hull.draft\": 4.0"), std::string::npos) << own;
}

TEST(Validation, EveryMethodStandsBesideTheOthersInEveryFile) {
    const ValidationReport r = report_by_methods();
    const std::vector<EstimatorSummary> all = estimators_of(r);
    ASSERT_EQ(all.size(), 3u);
    EXPECT_EQ(all[0].estimator, "trend_and_noise");
    EXPECT_EQ(all[0].given, 2);
    EXPECT_EQ(all[0].holds, 2);  // 3 off with 4 and 5; 8 off with 20
    EXPECT_EQ(all[1].given, 1);
    EXPECT_EQ(all[1].values, 2);
    EXPECT_EQ(all[2].holds, 2);
    EXPECT_EQ(all[2].narrow, 2);
    EXPECT_DOUBLE_EQ(all[2].median_U, 7.5);
    const std::string csv = validation_csv(r);
    EXPECT_NE(csv.find("U_trend_and_noise,U_eca_hoekstra,U_gci,U_factor_of_safety,version,date,kept\n"),
              std::string::npos)
        << csv;
    EXPECT_NE(csv.find(",4,2,6,"), std::string::npos) << csv;
    for (const std::string& text : {validation_html(r, {}, ""), validation_pages(r)[1].text, validation_text(r, {})}) {
        EXPECT_NE(text.find("GCI"), std::string::npos);
        EXPECT_NE(text.find("Eça"), std::string::npos);
    }
    EXPECT_NE(validation_pages(r)[1].text.find("input: hull.draft: 4, hull.trim: 3"), std::string::npos)
        << validation_pages(r)[1].text;
}

TEST(Validation, IsTheSameReadBackFromItsJson) {
    const fs::path file = fs::temp_directory_path() / "validation_test.json";
    const ValidationReport report = report_by_methods();
    write_text_atomically(file, validation_json(report));
    EXPECT_EQ(validation_json(read_validation(file)), validation_json(report));
    EXPECT_EQ(validation_pages(read_validation(file))[1].text, validation_pages(report)[1].text);
    write_text_atomically(file, "{\"title\": 1}");
    EXPECT_THROW(read_validation(file), InputError);
    std::string text = validation_json(small_report());
    text.replace(text.find("\"outcome\": \"met\""), 16, "\"outcome\": \"odd\"");
    write_text_atomically(file, text);
    EXPECT_THROW(read_validation(file), InputError);
    fs::remove(file);
}

TEST(Validation, JUnitParsesAndCounts) {
    ValidationReport report = small_report();
    report.cases[0].quantities[0].values[0] = judged(report.cases[0].quantities[0], nan, 0, 1);  // no value
    const auto parsed = [&] {
        std::istringstream in(validation_junit(report));
        boost::property_tree::ptree tree;
        boost::property_tree::read_xml(in, tree);
        return tree;
    };
    boost::property_tree::ptree tree = parsed();
    const auto count = [&](const char* what) { return tree.get<int>(std::string("testsuites.<xmlattr>.") + what); };
    EXPECT_EQ(count("tests"), 5);
    EXPECT_EQ(count("failures"), 2);
    EXPECT_EQ(count("errors"), 1);
    EXPECT_EQ(count("skipped"), 1);
    int failures = 0;
    for (const auto& [tag, suite] : tree.get_child("testsuites"))
        if (tag == "testsuite")
            for (const auto& [inner, test] : suite) failures += inner == "testcase" && test.count("failure") > 0;
    EXPECT_EQ(failures, 2);
    report.cases[1].quantities[0].known_miss["sph"] = "a reason";
    tree = parsed();
    EXPECT_EQ(count("failures"), 1);
    EXPECT_EQ(count("skipped"), 2);
}

TEST(Validation, TextOfASuiteIsTextInEveryFile) {
    const ValidationReport report = small_report();
    EXPECT_EQ(validation_html(report, {}, "").find("Lift <&>"), std::string::npos);
    EXPECT_NE(validation_html(report, {}, "").find("Lift &lt;&amp;&gt;"), std::string::npos);
    EXPECT_NE(validation_csv(report).find("tank,tanks,minutes,holds,N,sph,100,"), std::string::npos);
    EXPECT_NE(validation_pages(report)[1].text.find("# Tank \\| one"), std::string::npos);
}

TEST(Validation, TablesOfAPageWrittenByHandAreMadeAnewAndNothingElse) {
    const std::string page =
                          "# Mine\n\n<!-- validate: families -->\nof earlier data\n<!-- /validate -->\n\nkept | text\n"
                          "<!-- validate: values -->\n<!-- /validate -->\nend\n",
                      made = with_tables(page, "mine.md", small_report());
    for (const char* words :
         {"# Mine\n\n<!-- validate: families -->\nMade by", "\n\nkept | text\n", "\nend\n", "Lift", "tanks"})
        EXPECT_NE(made.find(words), std::string::npos) << words << "\n" << made;
    const std::string short_of =
        with_tables("<!-- validate: shortfalls -->\n<!-- /validate -->\n", "mine.md", small_report());
    EXPECT_NE(short_of.find("wave"), std::string::npos) << short_of;
    EXPECT_EQ(short_of.find("103 ± 4"), std::string::npos) << "this one misses nothing\n" << short_of;
    EXPECT_NE(short_of.find("108.0 ± 2.0"), std::string::npos) << short_of;
    EXPECT_EQ(made.find("of earlier data"), std::string::npos);
    EXPECT_EQ(with_tables(made, "mine.md", small_report()), made) << "made twice";
}

TEST(Validation, APlaceForATableThatIsWrongIsSaid) {
    const auto said = [](const std::string& page) -> std::string {
        try {
            return with_tables(page, "mine.md", small_report());
        } catch (const InputError& e) { return e.what(); }
    };
    EXPECT_NE(said("text\n").find("mine.md: no place for a table"), std::string::npos);
    EXPECT_NE(said("a\n<!-- validate: values -->\nb\n").find("mine.md:2: a place for a table has to end"),
              std::string::npos);
    EXPECT_NE(said("<!-- validate: x -->\n<!-- /validate -->\n").find("mine.md:1: no table \"x\""), std::string::npos);
}

/// README and STATUS show what validation/report.json holds.
TEST(Validation, CommittedTablesAreMadeFromTheCommittedReport) {
    const fs::path source = TWINWAKE_SOURCE;
    for (const char* page : {"README.md", "docs/STATUS.md"}) {
        const std::string text = read_text(source / page);
        EXPECT_EQ(text, with_tables(text, page, read_validation(source / "validation/report.json")))
            << "twinwake validate validation/report.json --out /tmp/validation --into " << page;
    }
}

/// The pages of docs/validation are those of validation/report.json: whoever changes one changes the other.
TEST(Validation, CommittedPagesAreMadeFromTheCommittedReport) {
    const fs::path source = TWINWAKE_SOURCE;
    std::size_t pages = 0;
    for (const MadePage& page : validation_pages(read_validation(source / "validation/report.json"))) {
        const fs::path file = source / "docs/validation" / page.name;
        ASSERT_TRUE(fs::exists(file)) << page.name;
        EXPECT_EQ(read_text(file), page.text)
            << page.name << ": twinwake validate validation/report.json --out /tmp/validation --pages docs/validation";
        ++pages;
    }
    for (const auto& entry : fs::directory_iterator(source / "docs/validation")) pages -= entry.is_regular_file();
    EXPECT_EQ(pages, 0u) << "a page of no case";
}

RunRecord record_of(double (*x)(double t), double end, double step) {
    RunRecord record;
    Table& table = record.table("height");
    Column& column = table.column("left", "m");
    for (double t = 0, k = 0; t <= end + 1e-9; ++k, t = step * (k + 0.3 * std::sin(k))) {
        table.time.push_back(t);
        column.values.push_back(x(t));
    }
    return record;
}
MeanValue read_off(const Reading& reading, const RunRecord& record) {
    return quantity_of(reading, "it", "It", record).values[0];
}

TEST(Reading, PeriodIsThatOfTheStrongestWaveBesideAnother) {
    const RunRecord two = record_of(
        [](double t) { return 3 + std::cos(2 * pi * t / 1.2) + 0.3 * std::cos(2 * pi * t / 0.55 + 1); }, 8, 0.02);
    const Reading period{"height", "left", Reading::Kind::period};
    EXPECT_NEAR(read_off(period, two).value, 1.2, 0.002);
    EXPECT_EQ(quantity_of(period, "it", "It", two).unit, "s");
    const RunRecord line = record_of([](double t) { return t; }, 8, 0.02);
    EXPECT_FALSE(read_off(period, line).known);
    EXPECT_NE(read_off(period, line).why_not.find("no oscillation"), std::string::npos);
}

TEST(Reading, MeanExtremesValueAndCrossing) {
    const RunRecord line = record_of([](double t) { return 2 * t; }, 4, 0.01);
    using Kind = Reading::Kind;
    EXPECT_NEAR(read_off({"height", "left", Kind::mean, 1, 3}, line).value, 4, 0.02);
    EXPECT_NEAR(read_off({"height", "left", Kind::largest, 1, 3}, line).value, 6, 0.05);
    EXPECT_NEAR(read_off({"height", "left", Kind::smallest, 1, 3}, line).value, 2, 0.05);
    EXPECT_NEAR(read_off({.table = "height", .column = "left", .kind = Kind::at, .at = 2.345}, line).value, 4.69, 1e-9);
    EXPECT_NEAR(read_off({.table = "height", .column = "left", .kind = Kind::crossing, .threshold = 5}, line).value,
                2.5, 1e-9);
    for (const auto& [reading, words] :
         {std::pair{Reading{"heights", "left"}, "no table \"heights\""},
          std::pair{Reading{"height", "right"}, "no column \"right\"; it has: left"},
          std::pair{Reading{"height", "left", Kind::mean, 1, 9}, "ends at"},
          std::pair{Reading{.table = "height", .column = "left", .kind = Kind::crossing, .threshold = 50},
                    "never crosses"}}) {
        const MeanValue m = read_off(reading, line);
        EXPECT_FALSE(m.known);
        EXPECT_NE(m.why_not.find(words), std::string::npos) << m.why_not;
    }
}

}  // namespace validation_test
}  // namespace tw

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compare/uncertainty/refinement_table.h"
#include "compare/uncertainty/report_uncertainty.h"
#include "tests/unit/compare/refinement_studies.h"

namespace tw {
namespace uncertainty_test {

RefinementTable table(const std::string& text) { return parse_refinement_table(text, "t.csv"); }
std::string error(const std::string& text) {
    return message([&] { table(text); });
}

TEST(RefinementTable, ColumnsOfAGoodTable) {
    const RefinementTable t = table(
        "# a study\n\nh [m], drag [N],\"lift, total [N]\"\n0.05, 412.1, 2722\n\n  # coarser\n0.1,+4.31e2,-2690\n");
    EXPECT_EQ(t.spacing_name, "h [m]");
    EXPECT_EQ(t.spacing, (std::vector<double>{0.05, 0.1}));
    ASSERT_EQ(t.columns.size(), 2u);
    EXPECT_EQ(t.columns[0].name, "drag [N]");
    EXPECT_EQ(t.columns[1].name, "lift, total [N]");
    EXPECT_EQ(t.columns[0].values, (std::vector<double>{412.1, 431}));
    EXPECT_EQ(t.columns[1].values, (std::vector<double>{2722, -2690}));
}

TEST(RefinementTable, SemicolonsTabsByteOrderMarkAndCarriageReturns) {
    for (const char* text :
         {"h;drag\n1;2\n2;3\n", "h\tdrag\n1\t2\n2\t3\n", "\xEF\xBB\xBFh,drag\r\n1,2\r\n2,3\r\n", "h,drag\n1,2\n2,3"}) {
        const RefinementTable t = table(text);
        EXPECT_EQ(t.spacing_name, "h");
        EXPECT_EQ(t.columns[0].name, "drag");
        EXPECT_EQ(t.spacing, (std::vector<double>{1, 2}));
        EXPECT_EQ(t.columns[0].values, (std::vector<double>{2, 3}));
    }
}

// cells.csv: h = N^(-1/3), so that the million is the finest; read as a spacing it was the coarsest.
TEST(RefinementTable, ACountIsTurnedIntoASpacing) {
    const std::string rows = "1000000,0.0301\n250000,0.0312\n60000,0.0335\n";
    for (const char* header : {"cells (3d)", "Number of particles [3-D]", "N 3d", "No. of elements 3D",
                               "grid points (3 dim)", "ncells_3d", "nodes (3D)"}) {
        const RefinementTable t = table(std::string(header) + ",cd\n" + rows);
        EXPECT_NEAR(t.spacing[0], 0.01, 1e-12) << header;
        EXPECT_EQ(estimate(study(t.spacing, t.columns[0].values)).levels[0].value, 0.0301) << header;
    }
    EXPECT_EQ(table("cells (3d),cd\n" + rows).spacing_name, "(cells (3d))^(-1/3)");
    const RefinementTable plane = parse_refinement_table("cells,cd\n" + rows, "t.csv", 2);
    EXPECT_NEAR(plane.spacing[1], 0.002, 1e-12);
    EXPECT_NE(
        error("# x\ncells,cd\n" + rows)
            .find("t.csv:2: first column \"cells\" found, a count and no spacing; the spacing is N^(-1/d), and d is "
                  "not said: give --dimensions 2 or 3"),
        std::string::npos);
    for (const char* header : {"Cells [million]", "particles", "N", "no. of elements", "n_nodes", "DOFs"})
        EXPECT_NE(error(std::string(header) + ",cd\n" + rows).find("a count and no spacing"), std::string::npos)
            << header;
}

TEST(RefinementTable, ANumberPerLengthIsTurnedIntoASpacingAndOtherWordsForSpacingsAreKnown) {
    for (const char* header : {"cells per beam", "D/dp", "1/h", "beam/near_hull", "N/L", "points per diameter"})
        EXPECT_EQ(table(std::string(header) + ",cd\n10,1\n20,2\n").spacing, (std::vector<double>{0.1, 0.05})) << header;
    for (const char* header :
         {"h", "dp [m]", "cell size", "particle spacing (mm)", "Δx", "dx", "near_hull [m]", "mesh size", "grid spacing",
          "h/D", "resolution [m]", "grid_mm", "particle diameter", "dt [s]"})
        EXPECT_EQ(table(std::string(header) + ",cd\n10,1\n20,2\n").spacing, (std::vector<double>{10, 20})) << header;
}

TEST(RefinementTable, AFirstColumnThatMayMeanEitherIsRefusedByName) {
    for (const char* header : {"grid", "Level", "run", "mesh", "resolution", "refinement ratio"})
        EXPECT_NE(
            error(std::string(header) + ",cd\n1,1\n2,2\n").find("may be a spacing, a count or a number of the row"),
            std::string::npos)
            << header;
    EXPECT_NE(error("tetrahedra,cd\n120000,1\n60000,2\n").find("first column \"tetrahedra\" found"), std::string::npos);
}

TEST(RefinementTable, ValuesAreKnownToTheirLastWrittenPlace) {
    const RefinementTable t = table("h,a,b,c\n1,0.0380,12,1.5e3\n2,0.038,13,2e2\n");
    EXPECT_NEAR(t.columns[0].rounding, 5e-5, 1e-12);
    EXPECT_NEAR(t.columns[1].rounding, 0.5, 1e-12);
    EXPECT_NEAR(t.columns[2].rounding, 50, 1e-9);
}

TEST(RefinementTable, OneRowIsATable) { EXPECT_EQ(table("h,drag\n0.1,5\n").spacing.size(), 1u); }

TEST(RefinementTable, FaultsAreNamedWithLineFoundAndExpected) {
    EXPECT_EQ(error("h,drag\n1,2\n2,\n"), "t.csv:3: no number in column \"drag\" found; expected one in every row");
    EXPECT_EQ(error("h,drag\n1,nan\n"), "t.csv:2: no number in column \"drag\" found; expected one in every row");
    EXPECT_EQ(error("h,drag\n# x\n1,2,3\n"),
              "t.csv:3: 3 cells found; expected 2 as in the header line (line 1: \"h\", \"drag\")");
    EXPECT_NE(error("h,drag\n1,high\n").find("t.csv:2:3: \"high\" found in column \"drag\"; expected a finite number"),
              std::string::npos);
    EXPECT_EQ(error("h;drag\n1,5;2\n"),
              "t.csv:2:1: \"1,5\" found in column \"h\"; expected a finite number with a decimal point, such as 1.5");
    EXPECT_EQ(error("h,drag\n0,2\n"), "t.csv:2: spacing 0 found; expected a spacing above zero");
    EXPECT_EQ(error("h,drag\n1,2\n2,3\n1.0,4\n"),
              "t.csv:4: spacing 1, as in line 2, found; expected a different spacing in every row");
    EXPECT_NE(error("0.1,5\n0.2,6\n").find("t.csv:1: a line of numbers found; expected a header line"),
              std::string::npos);
    EXPECT_NE(error("h drag\n1 2\n").find("t.csv:1: one column, \"h drag\", found"), std::string::npos);
    EXPECT_NE(error("h,,drag\n1,2,3\n").find("no name of column 2"), std::string::npos);
    EXPECT_NE(error("# only a comment\n").find("t.csv:1: no header line found"), std::string::npos);
    EXPECT_NE(error("h,drag\n").find("t.csv:1: no row found below the header line"), std::string::npos);
    EXPECT_THROW(read_refinement_table("no_such_table.csv"), InputError);
}

TEST(UncertaintyReport, ATableAndAVerdictForEveryQuantity) {
    const std::string text =
        uncertainty_text({{"drag [N]", estimate(noisy)}, {"a|b\x1b[31m", estimate(power(five, 1, 0.05, -1))}}, "h [m]");
    EXPECT_NE(text.find("\n5 levels, h [m] = 1 to 2.5; finest value 1.0511"), std::string::npos);
    EXPECT_NE(text.find("| least squares (Eca & Hoekstra)  |      5 |  1.56 | monotone |  1.00419 | 0.0602 |   5.7"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("drag [N]: converged (monotone, order 1.56): 1.05 ± 0.11 (11 %) by trend and noise"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("a\\|b?[31m: not converged (divergent)"), std::string::npos);
    EXPECT_EQ(text.find('\x1b'), std::string::npos);
}

TEST(UncertaintyReport, KeysForPrograms) {
    const auto one = nlohmann::json::parse(uncertainty_json({{"value", estimate(noisy)}}, "h"));
    for (const char* method : {"trend_and_noise", "eca_hoekstra", "celik_gci", "factor_of_safety"}) {
        for (const char* key : {"order", "limit", "uncertainty", "class"}) {
            EXPECT_TRUE(one.at(method).contains(key)) << method << " " << key;
            EXPECT_EQ(one.at(method).at(key), one.at("quantities").at(0).at(method).at(key));
        }
    }
    EXPECT_NEAR(one["eca_hoekstra"]["uncertainty"].get<double>(), 0.06022, 5e-6);
    EXPECT_EQ(one["eca_hoekstra"]["class"], "monotone");
    const auto two = nlohmann::json::parse(
        uncertainty_json({{"a", estimate(noisy)}, {"b", estimate(power(five, 1, 0.05, -1))}}, "h"));
    EXPECT_FALSE(two.contains("eca_hoekstra"));
    EXPECT_TRUE(two["quantities"][1]["uncertainty"].is_null());
    EXPECT_EQ(two["quantities"][1]["converged"], false);
}

}  // namespace uncertainty_test
}  // namespace tw

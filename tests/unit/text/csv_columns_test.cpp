#include "text/csv_columns.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/errors.h"

namespace tw {
namespace csv_columns_test {

std::string refusal(const std::string& text) {
    try {
        const CsvColumns csv(text, "a.csv");
        for (std::size_t c = 0; c < csv.headers().size(); ++c) csv.values(c);
    } catch (const InputError& e) { return e.what(); }
    return "sound";
}

TEST(CsvColumns, SeparatorQuotesCommentsAndLineEndsAsFilesComeFromInstruments) {
    const CsvColumns csv(
        "\xEF\xBB\xBF# logger 3, \"gain\" 2\r\n\r\n \"t; ms\" ; Lift, mean ;\"say \"\"x\"\"\";\r\n1;2.5e3; +7 ;\r\n"
        "# pause\r\n2; ;-0.5\r\n3;NaN;\"8\"\r\n",
        "a.csv");
    EXPECT_EQ(csv.headers(), (std::vector<std::string>{"t; ms", "Lift, mean", "say \"x\""}));
    ASSERT_EQ(csv.rows(), 3u);
    EXPECT_EQ(csv.values(0), (std::vector<double>{1, 2, 3}));
    EXPECT_EQ(csv.values(1)[0], 2500);
    EXPECT_TRUE(std::isnan(csv.values(1)[1]) && std::isnan(csv.values(1)[2]));
    EXPECT_EQ(csv.values(2), (std::vector<double>{7, -0.5, 8}));
    EXPECT_EQ(csv.line(0), 4);
    EXPECT_EQ(csv.line(2), 7);
    EXPECT_EQ(CsvColumns("a\tb;c,d\n1\t2\n", "a.csv").headers().size(), 2u);
    EXPECT_EQ(CsvColumns("a,b\n1,2\n", "a.csv").values(1)[0], 2);  // the last line may lack its end
    EXPECT_EQ(CsvColumns("a,b\n1,2", "a.csv").values(1)[0], 2);
}

TEST(CsvColumns, TextInAColumnThatNobodyAsksForIsNoFault) {
    const CsvColumns csv("t,remark,F\n1,start,2\n2,,3\n", "a.csv");
    EXPECT_EQ(csv.values(2)[1], 3);
    EXPECT_THROW(csv.values(1), InputError);
}

TEST(CsvColumns, FaultsNameFileLineAndColumn) {
    EXPECT_EQ(refusal("t,F\n0,1\n1, abc\n"),
              "a.csv:3:4: \"abc\" found in column \"F\"; expected a finite number, or nothing where there is none");
    EXPECT_EQ(refusal("t;F\n0;1,5\n"),
              "a.csv:2:3: \"1,5\" found in column \"F\"; expected a finite number with a decimal point, such as 1.5");
    EXPECT_NE(refusal("t,F\n0,inf\n").find("a.csv:2:3: \"inf\""), std::string::npos);
    EXPECT_NE(refusal("t,F\n0,1e999\n").find("a.csv:2:3: \"1e999\""), std::string::npos);
    EXPECT_NE(refusal("t,F\n0,1 N\n").find("a.csv:2:3: \"1 N\""), std::string::npos);
    EXPECT_EQ(refusal("t,F\n0,1\n\n1\n"),
              "a.csv:4: 1 cell found; expected 2 as in the header line (line 1: \"t\", \"F\")");
    EXPECT_EQ(refusal("t,F\n0,1,2\n"),
              "a.csv:2: 3 cells found; expected 2 as in the header line (line 1: \"t\", \"F\")");
    EXPECT_NE(refusal("").find("a.csv:1: an empty file found"), std::string::npos);
    EXPECT_NE(refusal("# only\n#remarks\n").find("a.csv:2: no header line found"), std::string::npos);
    EXPECT_NE(refusal("t,F\n").find("a.csv:1: no row found"), std::string::npos);
    EXPECT_NE(refusal("# t,F\n0,1\n1,2\n").find("a.csv:2: a line of numbers found"), std::string::npos);
    EXPECT_NE(refusal("lift\n1\n").find("a.csv:1: one column, \"lift\", found"), std::string::npos);
    EXPECT_NE(refusal(std::string("t,F\n0,\0\n", 8)).find("binary data"), std::string::npos);
    EXPECT_NE(refusal("\xFF\xFEt").find("UTF-16"), std::string::npos);
    // What stands in a message cannot steer a terminal.
    EXPECT_EQ(refusal("t,F\n0,\x1b[2J\n").find('\x1b'), std::string::npos);
}

}  // namespace csv_columns_test
}  // namespace tw

#include "compare/report/report_table.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compare/report/escape.h"

namespace tw {
namespace report_table_test {

ReportTable small() {
    ReportTable table{"Forces", {words("Quantity"), numbers("value", "N", 4), words("verdict")}};
    table.rows = {{{"Lift", 2722.26, ReportCell("not met", Mark::bad)}, "three sizes only"},
                  {{"Drag", std::nan(""), ReportCell("met", Mark::good)}}};
    table.notes = {"Means of the settled part."};
    return table;
}

TEST(ReportTable, TerminalPageAndFileHoldTheSameFacts) {
    EXPECT_EQ(text_of(small()),
              "## Forces\n\n"
              "| Quantity | value [N] | verdict     |\n"
              "|----------|----------:|-------------|\n"
              "| Lift     |      2722 | **not met** |\n"
              "| Drag     |         – | met         |\n"
              "\n- Lift: three sizes only\n"
              "\nMeans of the settled part.\n");
    const std::string page = html_of(small());
    for (const char* part :
         {"<h2>Forces</h2>", "<th class=\"num\">value [N]</th>", "<td class=\"num\">2722</td>",
          "<span class=\"badge differ\">not met</span>", "<tr class=\"remark\"><td colspan=\"3\">three sizes only</td>",
          "<td class=\"num\">–</td>", "<p class=\"note\">Means of the settled part.</p>"})
        EXPECT_NE(page.find(part), std::string::npos) << part << "\n" << page;
    EXPECT_EQ(csv_of(small()), "Quantity,value [N],verdict\nLift,2722.26,not met\nDrag,,met\n");
}

TEST(ReportTable, WithoutRowsThereIsNothing) {
    ReportTable empty = small();
    empty.rows.clear();
    EXPECT_EQ(text_of(empty), "");
    EXPECT_EQ(html_of(empty), "");
}

TEST(ReportTable, TextFromOutsideNeitherSteersATerminalNorEndsACellNorBecomesMarkup) {
    ReportTable table{"a\x1b[31m\nb", {words("<b>"), words("x|y")}};
    table.rows = {{{"l\x9b"
                    "1m|\r\n\tz",
                    "=cmd()"},
                   "</td><script>"}};
    table.notes = {
        "\xE2\x80\xAE"
        "turned"};  // U+202E turns the direction of writing
    const std::string text = text_of(table), page = html_of(table), csv = csv_of(table);
    EXPECT_EQ(text.find('\x1b'), std::string::npos);
    EXPECT_EQ(text.find('\x9b'), std::string::npos);
    EXPECT_EQ(text.find("\xE2\x80\xAE"), std::string::npos);
    EXPECT_NE(text.find("| l?1m\\|?  z | =cmd() |"), std::string::npos) << text;
    EXPECT_EQ(page.find("<script"), std::string::npos);
    EXPECT_EQ(page.find("<b>"), std::string::npos);
    EXPECT_EQ(page.find('\x1b'), std::string::npos);
    EXPECT_NE(csv.find("'=cmd()"), std::string::npos) << csv;
}

TEST(ReportTable, ATerminalGetsNoControlCharacterWhateverItsEncoding) {
    EXPECT_EQ(for_terminal("a\x1b[2Jb\x07"
                           "c\x7f"),
              "a?[2Jb?c?");
    EXPECT_EQ(for_terminal("C1: \xC2\x9B"
                           "31m"),
              "C1: ?31m");  // U+009B is CSI
    EXPECT_EQ(for_terminal("\xFF"), "?");
    EXPECT_EQ(for_terminal("über Ωmega ± −\ttab\nline"), "über Ωmega ± −\ttab\nline");
}

}  // namespace report_table_test
}  // namespace tw

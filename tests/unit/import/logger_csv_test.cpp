#include "import/logger_csv.h"

#include <cmath>

#include "import_folder.h"
#include "record/run_record.h"

namespace tw {
namespace logger_csv_test {

/// The same three rows, as each logger writes them: t = 0, 0.5, 1 s; drag 250, 260, 1270 N; lift 2.5, 2.6, 2.75 kN.
const std::string mapping = R"(
time = "t"
[forces]
fx = { column = "Drag", unit = "N" }
fz = { column = "Lift", unit = "kN" }
)";

class LoggerCsv : public ImportTest {
protected:
    /// What a logger's text becomes; `keys` stand in the mapping.
    void expect_the_rows(const std::string& text, const std::string& keys = "", const std::string& columns = mapping) {
        write("log.csv", text);
        try {
            const RunRecord r = imported("csv", "log.csv", keys + columns);
            const Table& forces = r.tables.at("forces");
            EXPECT_EQ(forces.time, (std::vector<double>{0, 0.5, 1})) << text;
            EXPECT_EQ(r.series("forces", "fx")->values, (std::vector<double>{250, 260, 1270})) << text;
            EXPECT_EQ(r.series("forces", "fz")->values, (std::vector<double>{2500, 2600, 2750})) << text;
        } catch (const InputError& e) { ADD_FAILURE() << e.what() << "\n" << text; }
    }
    std::string refusal_of(const std::string& text, const std::string& keys = "",
                           const std::string& columns = mapping) {
        write("log.csv", text);
        return refusal("csv", "log.csv", keys + columns);
    }
};

const std::string in_seconds = R"(
time = { column = "t", unit = "s" }
[forces]
fx = { column = "Drag", unit = "N" }
fz = { column = "Lift", unit = "kN" }
)";

TEST_F(LoggerCsv, ATableIsFoundHoweverItIsWritten) {
    expect_the_rows("t;Drag;Lift\n0;250;2,5\n0,5;260;2,6\n1;1270;2,75\n", "", in_seconds);  // decimal comma
    expect_the_rows("t\tDrag\tLift\r\n0,0\t250,0\t2,5\r\n0,5\t260\t2,6\r\n1,0\t1270\t2,75\r\n", "", in_seconds);
    expect_the_rows(
        "\"t\",\"Drag\",\"Lift\"\n\"0,0\",\"250\",\"2,5\"\n\"0,5\",\"260\",\"2,6\"\n\"1,0\",\"1270\",\"2,75\"\n", "",
        in_seconds);
    expect_the_rows("  t    Drag   Lift\n  0.0  250.0  2.5\n  0.5  260.0  2.6\n  1.0 1270.0  2.75\n", "", in_seconds);
    expect_the_rows("t,Drag,Lift\ns,N,kN\n0,250,2.5\n0.5,260,2.6\n1,1270,2.75\n");  // units row
    expect_the_rows("t;Drag;Lift\n[s];[N];[kN]\n0;250;2,5\n0,5;260;2,6\n1;1270;2,75\n");
    expect_the_rows("Facility;Tank 2\nRun;117\nDate;2024-05-01\n\nt;Drag;Lift\n0;250;2.5\n0.5;260;2.6\n1;1270;2.75\n",
                    "",
                    in_seconds);                                                                 // lines above
    expect_the_rows("t;Drag;Lift\n12:00:00;250;2,5\n12:00:00,5;260;2,6\n12:00:01;1270;2,75\n");  // clock
    expect_the_rows("t;Drag;Lift\nhh:mm:ss;N;kN\n12:00:00;250;2,5\n12:00:00,5;260;2,6\n12:00:01;1270;2,75\n");
    expect_the_rows(
        "t,Drag,Lift\n2024-05-01 23:59:59.5,250,2.5\n2024-05-02 00:00:00.0,260,2.6\n"
        "2024-05-02 00:00:00.5,1270,2.75\n");  // past midnight
    expect_the_rows(
        "\xEF\xBB\xBFLogger X\nChannel names below\nt;Drag;Lift\ns;N;kN\n0;250;2,5\n0,5;260;2,6\n1;1270;2,75\n\n");
}

TEST_F(LoggerCsv, AKeyDecidesWhatTheTextLeavesOpen) {
    const std::string thousands = refusal_of("t;Drag;Lift\n0;250;2\n1;1,270;3\n", "", in_seconds);
    EXPECT_TRUE(says(thousands, "decimal = \"comma\" or \"point\"")) << thousands;
    EXPECT_TRUE(says(refusal_of("t;Drag;Lift\n0;250;2\n1;260;2,600\n2;1,270;2\n", "decimal = \"comma\"\n", mapping),
                     "gives a unit"));  // read, and then the time's unit is asked for
    expect_the_rows("t;Drag;Lift\n0:0;250;2.5\n0:0.5;260;2.6\n0:1;1270;2.75\n", "clock = \"m:s\"\n");
    expect_the_rows("t;Drag;Lift\nsec;Newton;kN\n0;250;2.5\n0.5;260;2.6\n1;1270;2.75\n", "header_line = 1\n",
                    in_seconds);
    expect_the_rows("names;of;sensors\nt;Drag;Lift\nA;B;C\n0;250;2.5\n0.5;260;2.6\n1;1270;2.75\n", "header_line = 2\n",
                    in_seconds);
    expect_the_rows("0 250 2.5\n0.5 260 2.6\n1 1270 2.75\n", "header_line = 0\n", R"(
time = { column = 1, unit = "s" }
[forces]
fx = { column = 2, unit = "N" }
fz = { column = 3, unit = "kN" }
)");
    const std::string wrong = refusal_of("t;Drag;Lift\n0;250;2.5\n1;260;2.6\n", "separator = \"tab\"\n", in_seconds);
    EXPECT_TRUE(says(wrong, "map.toml:5:") && says(wrong, "no table was found")) << wrong;
    EXPECT_TRUE(says(refusal_of("t;Drag;Lift\n0;2;2\n", "decimal = \"dot\"\n"), "comma"));
    EXPECT_TRUE(says(refusal_of("t;Drag;Lift\n0:0:0;2;2\n0:0:1;2;2\n", "",
                                "time = { column = \"t\", unit = \"ms\" }\n[forces]\nfx = "
                                "{ column = 2, unit = \"N\" }\n"),
                     "times of day"));
}

// A row that is none of the table's must not end it unseen, and does not make another table of the rest.
TEST_F(LoggerCsv, AnOddRowIsNamedAndNothingAboveItIsLost) {
    const std::string text = refusal_of("t,Drag,Lift\n0,250,2.5\nx,y,z\n1,260,2.6\n", "", in_seconds);
    EXPECT_TRUE(says(text, "log.csv:3:1: \"x\" found in column \"t\"")) << text;
    const std::string comma = refusal_of("t;Drag;Lift\n0;250;2,5\nx;y;z\n1;260;2,6\n", "", in_seconds);
    EXPECT_TRUE(says(comma, "log.csv:3:1: \"x\" found in column \"t\"")) << comma;
    // what a logger writes when it pauses, when it ends, and when it is switched off while it writes
    const std::string above = "Facility;Tank 2\nRun;117\nRate;1000\nt;Drag;Lift\ns;N;kN\n0;250;2,5\n";
    for (const auto& [odd, rest] :
         {std::pair{"paused", "\n0,5;260;2,6\n1;1270;2,75\n"}, std::pair{"0,5;260;2,6;7", "\n1;1270;2,75\n"},
          std::pair{"End of test", "\n"}, std::pair{"0,5;26", ""}}) {
        const std::string said = refusal_of(above + odd + rest);
        EXPECT_TRUE(says(said, std::string("log.csv:7: \"") + odd + "\", ")) << said;
        EXPECT_TRUE(says(said,
                         "found below line 6, where the table begins, of 3 columns separated by semicolons with "
                         "decimal commas"))
            << said;
    }
    expect_the_rows(above + "# paused\n0,5;260;2,6\n1;1270;2,75\n");  // marked as no row
}

// Gaps and words in columns that nobody asks for are no odd rows.
TEST_F(LoggerCsv, GapsAndRemarksAreRows) {
    const std::string gap = "t;Drag;Lift;Note\n0;250;2,5;\n0,5;260;2,6;gust\n1;1270;2,75;\n";
    expect_the_rows(gap, "", in_seconds);
    write("log.csv", "t;Drag;Lift\n0;250;2,5\n0,5;260;\n1;;\n1,5;1270;2,75\n");
    const RunRecord r = imported("csv", "log.csv", in_seconds);
    EXPECT_EQ(r.tables.at("forces").time.size(), 4u);
    EXPECT_TRUE(std::isnan(r.series("forces", "fz")->values[1]));
    EXPECT_EQ(r.series("forces", "fx")->values[1], 260);
    // more lines above the table than in it
    expect_the_rows(
        "Tank;2\nRun;117\nRate;1000\nGain;4;5\nA;1\nB;2\nC;3\nt;Drag;Lift\n0;250;2,5\n0,5;260;2,6\n1;1270;2,75\n", "",
        in_seconds);
}

TEST_F(LoggerCsv, WhatIsPlainOrNoTableIsLeftAlone) {
    EXPECT_EQ(plain_csv("t,F\n0,1\n", "a.csv", {}).text, "t,F\n0,1\n");
    EXPECT_EQ(plain_csv("nothing of a table", "a.csv", {}).text, "nothing of a table");
}

}  // namespace logger_csv_test
}  // namespace tw

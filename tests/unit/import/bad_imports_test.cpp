#include "import_folder.h"

namespace tw {
namespace bad_imports_test {

const std::string columns =
    "time = { column = \"t\", unit = \"s\" }\n[forces]\nfz = { column = \"Lift\", unit = \"N\" }\n";

TEST_F(ImportTest, FilesThatAreNotThereOrNotWhatTheySay) {
    EXPECT_TRUE(
        says(refusal("csv", "none.csv", columns), "map.toml:3:10: source = \"none.csv\": there is no file none.csv"));
    write("empty.csv", "");
    EXPECT_TRUE(says(refusal("csv", "empty.csv", columns), "empty.csv:1: an empty file found"));
    std::string garbage;
    for (int i = 0; i < 4000; ++i) garbage += static_cast<char>((i * 7919) >> 3);
    write("garbage.csv", garbage);
    EXPECT_TRUE(says(refusal("csv", "garbage.csv", columns), "garbage.csv:1: binary data"));
    std::erase(garbage, '\0');
    write("garbage.csv", garbage);
    EXPECT_TRUE(says(refusal("csv", "garbage.csv", columns), "garbage.csv:"));
    EXPECT_TRUE(says(refusal("dualsphysics", "garbage.csv", ""), "garbage.csv"));
    std::filesystem::create_directory(folder / "folder.csv");
    EXPECT_TRUE(says(refusal("csv", "folder.csv", columns), "folder.csv: cannot be read"));
    EXPECT_THROW(import_record(folder / "none.toml"), InputError);
    EXPECT_THROW(import_record(folder), InputError);
    write("f.csv", "t,Lift\n0,1\n");
    write("map.toml", "kind = \"csv\"\nname = \"a\"\nsource = \"f.csv\"\nscene = \"other.toml\"\n" + columns);
    try {
        import_record(folder / "map.toml");
        FAIL();
    } catch (const InputError& e) { EXPECT_TRUE(says(e.what(), ":4:9: scene = \"other.toml\": there is no file")); }
}

TEST_F(ImportTest, OpenFoamFoldersThatAreNotThereOrNotWhatTheySay) {
    EXPECT_TRUE(says(refusal("openfoam", "case", ""), "there is no folder case"));
    std::filesystem::create_directories(folder / "case/postProcessing/forces");
    EXPECT_TRUE(says(refusal("openfoam", "case", ""), "no start-time folder of case/postProcessing/forces"));
    const std::string file = "case/postProcessing/forces/0/forces.dat";
    write(file, "");
    EXPECT_TRUE(says(refusal("openfoam", "case", ""), "forces.dat:1: no comment line found"));
    write(file, std::string("\x01\x02\x00 1 2 3 (4 5 6)\n", 18));
    EXPECT_TRUE(says(refusal("openfoam", "case", ""), "forces.dat:1: no comment line found"));
    write(file, "# Forces\n# Time\n");
    EXPECT_TRUE(says(refusal("openfoam", "case", ""), "hold no whole row yet"));
    write("case", "");
}

TEST_F(ImportTest, MissingColumnsListWhatTheFileHas) {
    write("f.csv", "t,Drag,lift\n0,1,2\n1,1,2\n");
    const std::string message = refusal("csv", "f.csv", columns);
    EXPECT_TRUE(says(message, "map.toml:7:6: [forces] fz")) << message;
    EXPECT_TRUE(says(message,
                     "there is no column \"Lift\"; the columns of f.csv are: \"t\", \"Drag\", \"lift\"; did you "
                     "mean 'lift'?"))
        << message;
    EXPECT_TRUE(says(refusal("csv", "f.csv", "time = 1\n[forces]\nfz = 4\n"), "gives a unit"));  // of the time
    EXPECT_TRUE(says(refusal("csv", "f.csv", "time = { column = 1, unit = \"s\" }\n[forces]\nfz = 4\n"),
                     "there is no column 4; f.csv has 3"));
    write("f.csv", "t,F,F\n0,1,2\n");
    EXPECT_TRUE(says(refusal("csv", "f.csv", "time = { column = 1, unit = \"s\" }\n[forces]\nfz = \"F\"\n"),
                     "2 columns are named \"F\""));
}

TEST_F(ImportTest, UnitsOfAnotherKindAreRefused) {
    write("f.csv", "t,Lift [mm],F\n0,1,2\n");
    const std::string time = "time = { column = \"t\", unit = \"s\" }\n[forces]\n";
    EXPECT_TRUE(says(refusal("csv", "f.csv", time + "fz = { column = \"F\", unit = \"kPa\" }\n"),
                     "[forces.fz] unit = \"kPa\": does not measure the right thing; expected a unit like N, mN, kN"));
    EXPECT_TRUE(says(refusal("csv", "f.csv", time + "fz = { column = \"F\", unit = \"kNewton\" }\n"), "unknown unit"));
    EXPECT_TRUE(
        says(refusal("csv", "f.csv", time + "fz = 2\n"), "column \"Lift [mm]\" of f.csv is in mm; expected unit"));
    EXPECT_TRUE(says(refusal("csv", "f.csv", time + "fz = \"F\"\n"),
                     "neither the mapping nor the header \"F\" of f.csv gives a unit; expected unit = \"N\""));
    EXPECT_TRUE(says(refusal("csv", "f.csv", time + "fz = { column = \"F\", unit = \"N\", scale = 0 }\n"), "not 0"));
}

TEST_F(ImportTest, TimesThatDoNotIncreaseAndCellsOfText) {
    write("f.csv", "# head\nt,Lift\n0,1\n0.2,1\n0.1,1\n");
    EXPECT_EQ(refusal("csv", "f.csv", columns), "f.csv:5: time 0.1 s found after 0.2 s; expected times that increase");
    write("f.csv", "t,Lift\n0,1\n0,1\n");
    EXPECT_TRUE(says(refusal("csv", "f.csv", columns), "f.csv:3: time 0 s found after 0 s"));
    write("f.csv", "t,Lift\n0,1\n,1\n");
    EXPECT_TRUE(says(refusal("csv", "f.csv", columns), "f.csv:3: no time found"));
    write("f.csv", "t,Lift\n0,1\n0.1,off\n");
    EXPECT_TRUE(says(refusal("csv", "f.csv", columns), "f.csv:3:5: \"off\" found in column \"Lift\""));
    write("f.csv", "t,Lift\n0,\n0.1,NaN\n");
    EXPECT_TRUE(says(refusal("csv", "f.csv", columns), "[forces] fz = {...}: fz of forces has no number in any row"));
}

TEST_F(ImportTest, UnknownKeysAndProbesAreNamedWithTheKnownOnes) {
    write("f.csv", "t,Lift\n0,1\n");
    EXPECT_TRUE(says(refusal("csv", "f.csv", "halfmodel = true\n" + columns), "did you mean 'half_model'?"));
    EXPECT_TRUE(says(refusal("csv", "f.csv", columns + "lift = 2\n"), "this section knows: fx, fx_pressure"));
    EXPECT_TRUE(says(refusal("csv", "f.csv", columns + "[forces.fx]\ncolum = 2\n"), "[forces.fx] column: missing"));
    EXPECT_TRUE(says(refusal("csv", "f.csv", columns + "[height]\nH9 = 2\n"),
                     "scene.toml has no height probe of this name; expected one of: gauge"));
    EXPECT_TRUE(says(refusal("csv", "f.csv", columns + "[volume]\nV9 = 2\n"),
                     "scene.toml has no box; expected a [[volume]] with name = \"V9\" there"));
    EXPECT_TRUE(says(refusal("csv", "f.csv", "function_object = \"forces\"\n" + columns), "unknown section or key"));
    EXPECT_TRUE(says(refusal("openfoam", "f.csv", columns), "unknown section or key"));
    EXPECT_TRUE(says(refusal("starccm", "f.csv", columns), "expected one of: csv, openfoam, dualsphysics"));
    EXPECT_TRUE(says(refusal("csv", "f.csv", "time = 1\n"), "no column is mapped"));
    EXPECT_TRUE(says(refusal("csv", "f.csv", "[forces]\nfz = 2\n"), "time: missing"));
    EXPECT_TRUE(says(refusal("csv", "f.csv", "time = 1.5\n[forces]\nfz = 2\n"), "expected a column"));
    EXPECT_TRUE(says(refusal("csv", "f.csv", "time = -1\n[forces]\nfz = 2\n"), "expected a column"));
    EXPECT_TRUE(says(refusal("csv", "f.csv", "forces = 3\n"), "expected a section [forces]"));
    EXPECT_TRUE(says(refusal("csv", "f.csv", "time = [\n"), "not valid TOML"));
}

TEST_F(ImportTest, NamesThatCouldSteerAReportOrATerminalAreRefused) {
    write("f.csv", "t,Lift\n0,1\n");
    const auto named = [&](const std::string& name) {
        write("map.toml",
              "kind = \"csv\"\nname = \"" + name + "\"\nsource = \"f.csv\"\nscene = \"scene.toml\"\n" + columns);
        import_record(folder / "map.toml");
    };
    for (const std::string bad :
         {"<script>", "a\\nb", "a\\u001b[2J", "a/b", "..", "-rf", " a", "a ", "ä", "=1+1", "sph", "fvm", ""})
        EXPECT_THROW(named(bad), InputError) << bad;
    EXPECT_THROW(named(std::string(41, 'a')), InputError);
    EXPECT_NO_THROW(named(std::string(40, 'a')));
    EXPECT_NO_THROW(named("STAR-CCM 2024.1_b"));
    // A source may lie anywhere, but the record does not tell where.
    write("map/f.csv", "t,Lift\n0,1\n");
    EXPECT_EQ(imported("csv", "map/../map/f.csv", columns).attributes.at("imported_from"), "f.csv");
    EXPECT_EQ(imported("csv", (folder / "f.csv").string(), columns).attributes.at("imported_from"), "f.csv");
}

/// Forces and moments of openfoam.com stand in two files, written together.
TEST_F(ImportTest, AnOpenFoamFileThatIsCutOffOrBlewUpIsRefused) {
    const auto file = [&](const char* name, int rows, const std::string& changed = "", int at = -1) {
        std::string text = "# " + std::string(name) + "\n";
        for (int i = 1; i <= rows; ++i)
            text += std::to_string(0.01 * i) + (i == at ? changed : " 1 2 3 1 2 3 0 0 0") + "\n";
        write("case/postProcessing/forces/0/" + std::string(name), text);
    };
    const auto both = [&](int forces, int moments) { file("force.dat", forces), file("moment.dat", moments); };
    both(80, 80);
    EXPECT_EQ(imported("openfoam", "case", "moment_point = [0, 0, 0]\n").tables.at("forces").time.size(), 80u);
    both(79, 80);
    EXPECT_EQ(imported("openfoam", "case", "moment_point = [0, 0, 0]\n").tables.at("forces").time.size(), 79u)
        << "the last row was being written";
    both(65, 80);
    EXPECT_TRUE(says(refusal("openfoam", "case", ""),
                     "moment.dat has 80 rows, and 65 of them have a row of the same "
                     "time in force.dat"));
    both(80, 65);
    EXPECT_TRUE(says(refusal("openfoam", "case", ""), "force.dat has 80 rows, and 65"));
    both(80, 80);
    file("force.dat", 80, " 1 2", 40);  // one in the middle
    EXPECT_TRUE(says(refusal("openfoam", "case", ""), "moment.dat has 80 rows, and 79"));
    for (const char* value : {"-inf", "inf", "nan"}) {
        file("force.dat", 80, " 1 2 3 " + std::string(value) + " 2 3 0 0 0", 70);
        EXPECT_TRUE(says(refusal("openfoam", "case", ""), "at t = 0.7 s; expected finite numbers")) << value;
    }
}

TEST_F(ImportTest, RowsThatAreGoneAreNamed) {
    const auto rows = [&](int from, int to, double growth) {
        std::string text = "t,Lift\n";
        double t = 0, step = 0.01;
        for (int i = 0; i < 100; ++i, t += step, step *= growth)
            if (i < from || i > to) text += std::to_string(t) + ",5\n";
        write("f.csv", text);
        write("map.toml", "kind = \"csv\"\nname = \"a\"\nsource = \"f.csv\"\nscene = \"scene.toml\"\n" + columns);
        const RunRecord record = import_record(folder / "map.toml");
        const auto gap = record.attributes.find("gap:forces");
        return gap == record.attributes.end() ? "" : gap->second;
    };
    EXPECT_TRUE(
        says(rows(24, 64, 1), "no row between 0.23 and 0.65 s, where a row every 0.01 s was expected: about 41"));
    EXPECT_EQ(rows(200, 300, 1), "");
    EXPECT_EQ(rows(200, 300, 1.1), "") << "a time step that grows";
}

}  // namespace bad_imports_test
}  // namespace tw

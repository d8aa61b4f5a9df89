// Time folders that a killed solver left, and files that restarts have split.
#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "foam_cases/read/number_rows.h"
#include "foam_cases/read/step_loads.h"
#include "foam_cases/read/time_folders.h"
#include "foam_cases/run/watchdog.h"

namespace tw {
namespace time_folders_test {
namespace fs = std::filesystem;

const std::string closing = "\n\n// ************************************************************************* //\n";

class TimeFoldersTest : public testing::Test {
protected:
    fs::path folder = fs::temp_directory_path() / ("foam_times_" + std::to_string(::getpid()));
    void SetUp() override { fs::create_directories(folder / "0"); }
    void TearDown() override { fs::remove_all(folder); }

    void write(const fs::path& path, const std::string& text) const {
        fs::create_directories((folder / path).parent_path());
        std::ofstream(folder / path, std::ios::binary) << text;
    }
    void whole_time(const std::string& name, const std::string& root = ".") const {
        for (const char* f : {"U", "p_rgh", "alpha.water", "phi", "uniform/time"})
            write(fs::path(root) / name / f, "values" + closing);
        write(fs::path(root) / name / "uniform/functionObjects/functionObjectProperties", "values" + closing);
    }
    std::vector<std::string> names() const {
        std::vector<std::string> out;
        for (const auto& m : TimeFolders(folder).moments()) out.push_back(m.name);
        return out;
    }
};
using Names = std::vector<std::string>;

TEST_F(TimeFoldersTest, HalfWrittenOnesAreDropped) {
    whole_time("0.1");
    whole_time("0.2");
    whole_time("0.3");
    write("0.3/U", "values\n// **** cut");  // killed while this file was written
    whole_time("0.4");
    fs::remove(folder / "0.4/phi");          // killed before it was
    write("0.5/yPlus", "values" + closing);  // written by a function object alone
    whole_time("0.6");
    write("0.6/uniform/functionObjects/functionObjectProperties", "cut");  // the last file of all
    EXPECT_EQ(TimeFolders(folder).prune(0), (Names{"0.3", "0.4", "0.5", "0.6"}));
    EXPECT_EQ(names(), (Names{"0.1", "0.2"}));
    EXPECT_TRUE(fs::exists(folder / "0")) << "the start is never dropped";
}

TEST_F(TimeFoldersTest, TurbulenceFieldsCountWhereTheCaseHasThem) {
    write("0.orig/k", "x");
    whole_time("0.1");
    EXPECT_EQ(TimeFolders(folder).prune(0), Names{"0.1"});
}

TEST_F(TimeFoldersTest, EveryProcessorMustHaveWrittenItsShare) {
    for (const char* p : {"processor0", "processor1", "processor10"}) whole_time("0.1", p);
    whole_time("0.2", "processor0");
    whole_time("0.2", "processor10");
    const TimeFolders folders(folder);
    ASSERT_EQ(folders.roots().size(), 3u);
    EXPECT_EQ(folders.roots()[2].filename(), "processor10") << "ascending by number, as decomposePar shares cells out";
    EXPECT_EQ(folders.prune(0), Names{"0.2"});
    EXPECT_FALSE(fs::exists(folder / "processor0/0.2"));
}

TEST_F(TimeFoldersTest, TimesOffTheWriteIntervalGoSoThatTheClockIsNotShifted) {
    whole_time("0.1");
    whole_time("0.20000001");  // eight digits of OpenFOAM's names
    whole_time("0.2345");      // written because a stop was asked for
    EXPECT_EQ(TimeFolders(folder).prune(0.1), Names{"0.2345"});
}

TEST_F(TimeFoldersTest, ForceFilesOfLaterStartsWin) {
    write("forces/0/force.dat",
          "# Force\n# Time \t(total)\n0.1\t(1 2 3) (4 5 6) (7 8 9)\n0.2\t(2 2 3) (4 5 6) (7 8 9)\n0.3\t(3 2 3) (4 5 6) "
          "(7 8 9)\n0.4\t(4 2");
    write("forces/0.25/force.dat", "# Force\n0.28 (9 2 3) (4 5 6) (7 8 9)\n0.35 (8 2 3) (4 5 6) (7 8 9)\n");
    const auto rows = joined_rows(folder / "forces", "force.dat");
    ASSERT_EQ(rows.size(), 4u);
    EXPECT_EQ(rows[2], (std::vector<double>{0.28, 9, 2, 3, 4, 5, 6, 7, 8, 9}));
    EXPECT_EQ(rows[3][0], 0.35);
    EXPECT_TRUE(joined_rows(folder / "nothing", "force.dat").empty());
}

std::string row(double time, double fx) {
    const auto n = [](double v) { return std::to_string(v); };
    return n(time) + " (" + n(fx) + " 2 3) (4 5 6) (7 8 9)\n";
}
/// Time and fx of every row.
std::vector<std::pair<double, double>> times_and_fx(const std::vector<std::vector<double>>& rows) {
    std::vector<std::pair<double, double>> out;
    for (const auto& r : rows) out.emplace_back(r.at(0), r.at(1));
    return out;
}
using Pairs = std::vector<std::pair<double, double>>;

TEST_F(TimeFoldersTest, AStartFromATimeOnceMoreIsReadFromTheFileBesideTheFirst) {
    // Killed before its first write time: the solver starts from 0 again and leaves the first file alone.
    write("forces/0/force.dat", "# Force\n" + row(0.1, 1) + row(0.2, 1) + row(0.9, 1));
    write("forces/0/force_0.dat", "# Force\n" + row(0.15, 2) + row(0.3, 2) + row(0.5, 2));
    write("forces/0/force_bin.dat", "# Force\n" + row(0.7, 9));  // of another kind
    EXPECT_EQ(times_and_fx(joined_rows(folder / "forces", "force.dat")), (Pairs{{0.15, 2}, {0.3, 2}, {0.5, 2}}));
    write("forces/0.4/force.dat", "# Force\n" + row(0.45, 3) + row(0.6, 3));
    write("forces/0.4/force_0.4.dat", "# Force\n" + row(0.48, 4));
    EXPECT_EQ(times_and_fx(joined_rows(folder / "forces", "force.dat")), (Pairs{{0.15, 2}, {0.3, 2}, {0.48, 4}}))
        << "what a start has computed beyond the time that the next one starts from is no part of the run";
}

TEST_F(TimeFoldersTest, RowsThatAFullDiskHasCutOrGluedAreLeftOutAndNoOthers) {
    write("forces/0/force.dat", "# Force\n0.05 (1 2\n" + row(0.1, 1) + "0.2 (1 2 3) (4 5" + row(0.25, 1) + row(0.3, 1));
    EXPECT_EQ(times_and_fx(joined_rows(folder / "forces", "force.dat")), (Pairs{{0.1, 1}, {0.3, 1}}));
    // A force without its moment takes no others with it.
    write("forces/0/moment.dat", "# Moment\n" + row(0.2, 7) + row(0.3, 7));
    EXPECT_EQ(read_loads(folder / "forces").time, std::vector<double>{0.3});
}

TEST_F(TimeFoldersTest, OutputLaterThanTheRestartIsForgotten) {
    write("postProcessing/forces/0/force.dat", "x");
    write("postProcessing/forces/0.2/force.dat", "x");
    write("postProcessing/forces/0.4/force.dat", "x");  // its state was half-written and is gone
    write("postProcessing/hullSurface/0.4/hull.vtp", "x");
    TimeFolders(folder).forget_output_after(0.2);
    EXPECT_TRUE(fs::exists(folder / "postProcessing/forces/0"));
    EXPECT_TRUE(fs::exists(folder / "postProcessing/forces/0.2"));
    EXPECT_FALSE(fs::exists(folder / "postProcessing/forces/0.4"));
    EXPECT_FALSE(fs::exists(folder / "postProcessing/hullSurface/0.4"));
}

TEST_F(TimeFoldersTest, TheLargestVelocityIsTheLastOnesMaximum) {
    write("pp/fastest/0/fieldMinMax.dat",
          "# Field minima and maxima\n# Time field min position(min) max position(max)\n"
          "0.1\tmag(U)\t1.5e-01\t(1.9 2.6e-02 -1.7e-01)\t1.30e+01\t(2.0 4.1e-01 2.6e-03)\n"
          "0.2\tmag(U)\t1.2e-01\t(-1.1 6.5e-02 8.3e-01)\t1.55e+01\t(2.0 4.1e-01 2.6e-03)\n");
    EXPECT_DOUBLE_EQ(latest_fastest(folder / "pp", 1), 15.5);
    // In parallel the processor's number stands between place and maximum.
    write("pp/fastest/0.2/fieldMinMax.dat", "# Time\n0.3 mag(U) 0.1 (1 2 3) 0 17.5 (2 0.4 0) 1\n");
    EXPECT_DOUBLE_EQ(latest_fastest(folder / "pp", 1), 17.5);
    EXPECT_TRUE(std::isnan(latest_fastest(folder / "none", 1)));
    // openfoam.org from 9 on: volFieldValue, whose table begins with what it was taken over.
    write("org/fastest/0/volFieldValue.dat", "# Region : all\n# Time        \tmaxMag(U)\n0.1\t9.5\n0.2\t10.5\n");
    EXPECT_DOUBLE_EQ(latest_fastest(folder / "org", 1), 10.5);
    EXPECT_TRUE(std::isnan(latest_fastest(folder / "org", 0.15)));
    write("new/fastest/0/volFieldValue.dat", "# Region : all\n# Time        \tmaxMag(U)\n");
    EXPECT_TRUE(std::isnan(latest_fastest(folder / "new", 1)));
    // Started from 0.2 once more: the file beside the first is the one that grows.
    write("pp/fastest/0.2/fieldMinMax_0.2.dat", "# Time\n0.25 mag(U) 0.1 (1 2 3) 99 (2 0.4 0)\n");
    EXPECT_DOUBLE_EQ(latest_fastest(folder / "pp", 0.25), 99);
    EXPECT_TRUE(std::isnan(latest_fastest(folder / "pp", 0.22))) << "the new start has not come so far";
}

}  // namespace time_folders_test
}  // namespace tw

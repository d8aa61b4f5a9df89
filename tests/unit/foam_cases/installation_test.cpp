// Which OpenFOAM is taken, and in what environment its programs run: releases made of shell scripts.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "foam_cases/doctor.h"
#include "foam_cases/run/case_programs.h"

namespace tw {
namespace installation_test {
namespace fs = std::filesystem;

constexpr const char* tells = "echo args=\"$@\"; echo PWD=$PWD; echo DIR=$WM_PROJECT_DIR; echo LIB=$LD_LIBRARY_PATH\n";

class InstallationTest : public testing::Test {
protected:
    fs::path folder = fs::temp_directory_path() / ("foam_releases_" + std::to_string(::getpid()));
    std::map<std::string, std::string> before;

    void set(const char* name, const std::string& value) {
        const char* was = std::getenv(name);
        before.emplace(name, was == nullptr ? "" : was);
        ::setenv(name, value.c_str(), 1);
    }
    void SetUp() override {
        for (const char* name :
             {"WM_PROJECT_DIR", "TWINWAKE_OPENFOAM_BIN", "TWINWAKE_OPENFOAM_PREFIX", "LD_LIBRARY_PATH", "WM_OPTIONS"})
            set(name, "");
        set("TWINWAKE_OPENFOAM_PLACES", "/nowhere");
        set("HOME", folder.string());
    }
    void TearDown() override {
        for (const auto& [name, value] : before)
            value.empty() ? ::unsetenv(name.c_str()) : ::setenv(name.c_str(), value.c_str(), 1);
        fs::remove_all(folder);
    }
    void program(const fs::path& path, const std::string& script) {
        fs::create_directories(path.parent_path());
        std::ofstream(path) << "#!/bin/sh\n" << script;
        fs::permissions(path, fs::perms::owner_all);
    }
    fs::path bin_of(const std::string& name) { return folder / name / "platforms/linux64GccDPInt32Opt/bin"; }
    /// A release whose solver knows the answer of the self-test: 0.1 m/s along a pipe turned by 0.5 and 0.7.
    fs::path release(const std::string& name, const std::string& api, bool right = true) {
        fs::create_directories(folder / name / "etc");
        fs::create_directories(folder / name / "META-INFO");
        std::ofstream(folder / name / "etc/controlDict") << "\n";
        std::ofstream(folder / name / "META-INFO/api-info") << "api=" << api << "\n";
        program(bin_of(name) / "blockMesh", "exit 0\n");
        program(
            bin_of(name) / "interFoam",
            "mkdir -p 0.1; cat > 0.1/U <<'END'\nFoamFile{version 2.0; format ascii; class volVectorField; object U;}\n"
            "dimensions [0 1 -1 0 0 0 0];\ninternalField nonuniform List<vector> 1\n(\n(" +
                std::string(right ? "0.0877582561890373" : "0.09") + " 0.0366682996 0.0308852866)\n)\n;\nEND\n");
        return folder / name;
    }
    static std::string refusal(const std::string& preferred = {}) {
        try {
            sound_openfoam(preferred);
        } catch (const InputError& e) { return e.what(); }
        return "taken";
    }
};

TEST_F(InstallationTest, TheReleaseWhoseEnvironmentIsLoadedWins) {
    const fs::path loaded = release("v2506", "2506"), other = release("v2312", "2312");
    set("TWINWAKE_OPENFOAM_PLACES", other.string());
    EXPECT_EQ(sound_openfoam().version, "v2312");
    set("WM_PROJECT_DIR", loaded.string());
    EXPECT_EQ(sound_openfoam().version, "v2506");
    EXPECT_TRUE(find_openfoam().front().loaded);
    EXPECT_EQ(sound_openfoam(other.string()).version, "v2312") << "a scene may name another";
    // A faulty one is refused: none of the others is what the user has asked for.
    release("v2506", "2506", false);
    EXPECT_NE(refusal().find("(WM_PROJECT_DIR) cannot be used"), std::string::npos) << refusal();
    EXPECT_EQ(refusal(other.string()), "taken");
}

TEST_F(InstallationTest, ItWinsOverTheMendedSolverOfDebian) {
    if (!fs::exists("/usr/bin/blockMesh") || !fs::exists("/usr/share/openfoam/etc/controlDict"))
        GTEST_SKIP() << "Debian's OpenFOAM is not here";
    program(folder / "mended/bin/interFoam",
            read_text(release("v2506", "2506") / "platforms/linux64GccDPInt32Opt/bin/interFoam"));
    set("TWINWAKE_OPENFOAM_BIN", (folder / "mended/bin").string());
    set("TWINWAKE_OPENFOAM_PLACES", "/usr/share/openfoam");
    EXPECT_EQ(sound_openfoam().solver, folder / "mended/bin/interFoam");
    set("WM_PROJECT_DIR", (folder / "v2506").string());
    EXPECT_EQ(sound_openfoam().solver, bin_of("v2506") / "interFoam");
}

TEST_F(InstallationTest, TheLibraryOfWallsIsThatOfTheRelease) {
    set("WM_PROJECT_DIR", release("v2506", "2506").string());
    set("TWINWAKE_OPENFOAM_BIN", (folder / "own/bin").string());
    const auto library = [&](const std::string& of_release) {
        fs::path file = folder / "own/walls" / of_release / "libventilatedWall.so";
        fs::create_directories(file.parent_path());
        std::ofstream(file) << "\n";
        return file;
    };
    library("openfoam.com-v2312");
    EXPECT_TRUE(sound_openfoam().wall_library.empty());
    const fs::path wanted = library("openfoam.com-v2506");
    EXPECT_EQ(sound_openfoam().wall_library, wanted);
    EXPECT_NE(sound_openfoam().verdict.find("walls allow separation"), std::string::npos) << sound_openfoam().verdict;
    // One that spoils the answer is left out.
    const std::string solver = read_text(bin_of("v2506") / "interFoam");
    program(bin_of("v2506") / "interFoam", "grep -q libventilatedWall system/controlDict && exit 1\n" + solver);
    EXPECT_TRUE(sound_openfoam().wall_library.empty());
    EXPECT_NE(sound_openfoam().verdict.find("walls hold water"), std::string::npos) << sound_openfoam().verdict;
}

TEST_F(InstallationTest, ALibraryOfZonesThatSpoilsTheAnswerIsLeftOutAndThatOfWallsIsKept) {
    set("WM_PROJECT_DIR", release("v2506", "2506").string());
    set("TWINWAKE_OPENFOAM_BIN", (folder / "own/bin").string());
    const fs::path libraries = folder / "own/walls/openfoam.com-v2506";
    fs::create_directories(libraries);
    for (const char* file : {"libventilatedWall.so", "libforcingZones.so"}) std::ofstream(libraries / file) << "\n";
    EXPECT_EQ(sound_openfoam().zone_library, libraries / "libforcingZones.so");
    EXPECT_NE(sound_openfoam().verdict.find("walls allow separation; forcing zones absorb waves"), std::string::npos);
    const std::string solver = read_text(bin_of("v2506") / "interFoam");
    program(bin_of("v2506") / "interFoam", "grep -q libforcingZones system/controlDict && exit 1\n" + solver);
    const OpenFoam found = sound_openfoam();
    EXPECT_TRUE(found.zone_library.empty());
    EXPECT_EQ(found.wall_library, libraries / "libventilatedWall.so");
    EXPECT_NE(found.verdict.find("walls allow separation; forcing zones are missing"), std::string::npos)
        << found.verdict;
}

// Of three libraries only those that spoil the answer are left out.
TEST_F(InstallationTest, ALibraryOfHeldHullsIsUsedUnlessItSpoilsTheAnswer) {
    set("WM_PROJECT_DIR", release("v2506", "2506").string());
    set("TWINWAKE_OPENFOAM_BIN", (folder / "own/bin").string());
    const fs::path libraries = folder / "own/walls/openfoam.com-v2506", solver = bin_of("v2506") / "interFoam";
    fs::create_directories(libraries);
    for (const char* file : {"libventilatedWall.so", "libforcingZones.so", "libheldBody.so"})
        std::ofstream(libraries / file) << "\n";
    OpenFoam found = sound_openfoam();
    EXPECT_EQ(found.hold_library, libraries / "libheldBody.so");
    EXPECT_NE(found.verdict.find("a free hull is held until its release"), std::string::npos) << found.verdict;
    const std::string answer = read_text(solver);
    program(solver, "grep -q libheldBody system/controlDict && exit 1\n" + answer);
    found = sound_openfoam();
    EXPECT_TRUE(found.hold_library.empty());
    EXPECT_FALSE(found.wall_library.empty() || found.zone_library.empty());
    EXPECT_NE(found.verdict.find("a free hull is free at once"), std::string::npos) << found.verdict;
    program(solver, "grep -q 'libventilatedWall\\|libforcingZones' system/controlDict && exit 1\n" + answer);
    found = sound_openfoam();
    EXPECT_TRUE(found.wall_library.empty() && found.zone_library.empty());
    EXPECT_EQ(found.hold_library, libraries / "libheldBody.so");
}

// interFoam of openfoam.com asks for cAlpha, openfoam.org 13 stops where it finds one.
TEST_F(InstallationTest, TheSelfTestHasTheCompressionWhereTheReleaseReadsIt) {
    const fs::path com = release("v2506", "2506"), org = release("13", "0");
    const std::string answer = read_text(bin_of("v2506") / "interFoam"), has = "grep -q cAlpha system/fvSolution";
    program(bin_of("v2506") / "interFoam", has + " || exit 1\n" + answer);
    program(bin_of("13") / "foamRun", has + " && exit 1\n" + answer);
    fs::remove_all(org / "META-INFO");
    std::ofstream(org / "etc/bashrc") << "export WM_PROJECT_VERSION=13\n";
    for (const fs::path& loaded : {com, org}) {
        set("WM_PROJECT_DIR", loaded.string());
        EXPECT_EQ(refusal(), "taken");
        EXPECT_EQ(sound_openfoam().project_dir, loaded);
    }
}

TEST_F(InstallationTest, ProgramsAreOfTheReleasesOwnFolderOrNamedAsMissing) {
    const fs::path loaded = release("v2506", "2506"), other = release("v2312", "2312");
    set("TWINWAKE_OPENFOAM_PLACES", other.string());
    set("WM_PROJECT_DIR", loaded.string());
    program(bin_of("v2312") / "snappyHexMesh", "exit 0\n");
    set("PATH", bin_of("v2312").string() + ":" + std::getenv("PATH"));
    try {
        CasePrograms(sound_openfoam(), folder).start("snappyHexMesh", {}, "snappyHexMesh");
        FAIL() << "a program of another release was started";
    } catch (const RunError& e) {
        EXPECT_NE(std::string(e.what()).find("'snappyHexMesh' is not in"), std::string::npos);
    }
    fs::remove(bin_of("v2506") / "interFoam");
    EXPECT_NE(refusal().find("v2506, unusable: it has no interFoam"), std::string::npos) << refusal();
    fs::remove(bin_of("v2506") / "blockMesh");
    EXPECT_NE(refusal().find("v2506, unusable: it has no blockMesh"), std::string::npos) << refusal();
}

TEST_F(InstallationTest, RanksKeepTheReleasesLibrariesAndTheFolderIsTheCase) {
    const fs::path loaded = release("v2506", "2506");
    set("WM_PROJECT_DIR", loaded.string());
    program(bin_of("v2506") / "mpirun", tells);
    const CasePrograms programs(sound_openfoam(), folder);
    EXPECT_TRUE(programs.start("blockMesh", {}, "ranks", 2)->wait().ok());
    const std::string told = read_text(programs.log("ranks"));
    EXPECT_NE(told.find(" --noprefix "), std::string::npos) << told;
    EXPECT_NE(told.find("PWD=" + folder.string() + "\n"), std::string::npos) << told;
}

// 5 % of a run's time (docs/decisions/015-interfoam-settings.md); who sets one of them gets it.
TEST_F(InstallationTest, ProgramsKeepTheirMemoryUnlessTheUserSaysOtherwise) {
    set("WM_PROJECT_DIR", release("v2506", "2506").string());
    set("MALLOC_TOP_PAD_", "4096");
    program(bin_of("v2506") / "tells", "echo $MALLOC_MMAP_THRESHOLD_ $MALLOC_TRIM_THRESHOLD_ $MALLOC_TOP_PAD_\n");
    const CasePrograms programs(sound_openfoam(), folder);
    programs.run("tells", {}, {});
    EXPECT_EQ(read_text(programs.log("tells")), "33554432 1073741824 4096\n");
}

TEST_F(InstallationTest, BehindAPrefixProgramsRunInTheEnvironmentThere) {
    const fs::path inside = release("v2506", "2506");
    program(bin_of("v2506") / "mpirun", tells);
    program(bin_of("v2506") / "tells", tells);
    program(folder / "container", "shift; export WM_PROJECT_DIR=" + inside.string() +
                                      " WM_PROJECT_VERSION=v2506 FOAM_APPBIN=" + bin_of("v2506").string() +
                                      " PATH=" + bin_of("v2506").string() + ":$PATH\nexec \"$@\"\n");
    set("LD_LIBRARY_PATH", "/opt/mine/lib");
    set("TWINWAKE_OPENFOAM_PREFIX", (folder / "container").string() + "  exec ");
    const OpenFoam found = sound_openfoam();
    EXPECT_EQ(found.vendor + " " + found.version, "openfoam.com v2506");
    EXPECT_EQ(found.command(), (folder / "container").string() + " exec " + (bin_of("v2506") / "interFoam").string());
    const fs::path library = folder / ".local/share/twinwake/openfoam/walls/openfoam.com-v2506/libforcingZones.so";
    EXPECT_TRUE(found.zone_library.empty());
    fs::create_directories(library.parent_path());
    std::ofstream(library) << "\n";
    EXPECT_EQ(sound_openfoam().zone_library, library);
    const CasePrograms programs(found, folder);
    programs.run("tells", {"a b; c"}, {});
    std::string told = read_text(programs.log("tells"));
    EXPECT_NE(told.find("args=a b; c -case " + folder.string() + "\n"), std::string::npos) << told;
    EXPECT_NE(told.find("DIR=" + inside.string() + "\n"), std::string::npos) << told;
    EXPECT_NE(told.find("LIB=/opt/mine/lib\n"), std::string::npos) << told;
    EXPECT_TRUE(programs.start("tells", {}, "ranks", 2)->wait().ok());
    told = read_text(programs.log("ranks"));
    EXPECT_NE(told.find("args=-np 2 "), std::string::npos) << "mpirun runs there too: " << told;
}

TEST_F(InstallationTest, APrefixThatLeadsToNoOpenFoamIsRefusedWithWhatIsWrong) {
    set("TWINWAKE_OPENFOAM_PREFIX", "no_such_container exec of.sif");
    EXPECT_NE(refusal().find("'no_such_container', the first word of TWINWAKE_OPENFOAM_PREFIX, is not on the PATH"),
              std::string::npos)
        << refusal();
    set("TWINWAKE_OPENFOAM_PREFIX", "env");
    EXPECT_NE(refusal().find("no OpenFOAM's environment is loaded behind it"), std::string::npos) << refusal();
    program(folder / "broken", "echo of.sif: no such image; exit 255\n");
    set("TWINWAKE_OPENFOAM_PREFIX", (folder / "broken").string());
    EXPECT_NE(refusal().find("printenv behind it failed (exit status 255): of.sif: no such image"), std::string::npos)
        << refusal();
}

TEST_F(InstallationTest, AnotherReleasesEnvironmentIsTakenOut) {
    const fs::path loaded = release("v2506", "2506"), other = release("v2312", "2312");
    set("WM_PROJECT_DIR", loaded.string() + "/");
    set("WM_OPTIONS", "linux64GccDPInt32Opt");
    set("LD_LIBRARY_PATH", (loaded / "platforms/x/lib").string() + ":/opt/mine/lib");
    program(bin_of("v2312") / "blockMesh", tells);
    const CasePrograms named(sound_openfoam(other.string()), folder);
    named.run("blockMesh", {}, {});
    const std::string told = read_text(named.log("blockMesh"));
    EXPECT_NE(told.find("DIR=" + other.string() + "\n"), std::string::npos) << told;
    EXPECT_NE(told.find("LIB=/opt/mine/lib\n"), std::string::npos) << told;
}

}  // namespace installation_test
}  // namespace tw

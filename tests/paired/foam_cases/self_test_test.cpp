// The doctor's flow with an exact answer tells sound solvers from miscompiled ones.
#include "base/errors.h"
#include "foam_test.h"

namespace tw {
namespace self_test_test {
namespace fs = std::filesystem;

using SelfTest = FoamTest;

TEST_F(SelfTest, AtLeastOneSolverHereIsSoundAndIsTheOneThatIsUsed) {
    const OpenFoam used = sound_openfoam();
    EXPECT_TRUE(used.sound) << used.verdict;
    EXPECT_LT(used.self_test_error, 1e-5);
    EXPECT_NE(used.verdict.find("sound"), std::string::npos);
    EXPECT_FALSE(used.version.empty());
}

using Library = fs::path OpenFoam::*;

/// A library with which the installation passes, as its verdict `says`, is left out where another stands in its place:
/// that one loads and has nothing of it. The other stays in use.
void is_used_or_left_out(Library library, Library other, const char* says) {
    OpenFoam used = sound_openfoam();
    EXPECT_LT(used.self_test_error, 1e-5);
    EXPECT_NE(used.verdict.find(says), std::string::npos) << used.verdict;
    const fs::path stays = used.*other;
    used.*library = stays;
    self_test(used);
    EXPECT_TRUE(used.sound) << used.verdict;
    EXPECT_TRUE((used.*library).empty());
    EXPECT_EQ(used.*other, stays);
}

// Half of the push in the pipe is then that of a zone: one that does nothing, or the other way round, spoils the
// answer.
TEST_F(SelfTest, AZoneDrawsTheFlowAsImplicitEulerStepsSayOrItsLibraryIsLeftOut) {
    if (sound_openfoam().zone_library.empty()) GTEST_SKIP() << "no library of zones: twinwake setup-openfoam builds it";
    is_used_or_left_out(&OpenFoam::zone_library, &OpenFoam::wall_library, "forcing zones absorb waves");
}

// The pipe's sides then begin to move across it: unless they are held they take the water along.
TEST_F(SelfTest, APipeThatBeginsToMoveIsHeldOrTheLibraryIsLeftOut) {
    if (sound_openfoam().hold_library.empty())
        GTEST_SKIP() << "no library that holds hulls: twinwake setup-openfoam builds it";
    is_used_or_left_out(&OpenFoam::hold_library, &OpenFoam::zone_library, "a free hull is held");
}

/// Debian's OpenFOAM 1912 is the faulty one that this test was made for. Without it the test cannot show that it can
/// fail.
class PackagedSolver : public FoamTest {
protected:
    OpenFoam packaged() const {
        for (const OpenFoam& f : find_openfoam())
            if (f.solver == "/usr/bin/interFoam" && f.version == "v1912") return f;
        return {};
    }
};

TEST_F(PackagedSolver, IsFaultyAndRefusedByName) {
    const OpenFoam faulty = packaged();
    if (faulty.solver.empty()) GTEST_SKIP() << "Debian's OpenFOAM 1912 is not installed";
    EXPECT_FALSE(faulty.sound);
    EXPECT_GT(faulty.self_test_error, 0.01);
    ::setenv("TWINWAKE_OPENFOAM_BIN", "/usr/bin", 1);
    ::setenv("HOME", folder.c_str(), 1);
    try {
        sound_openfoam();
        FAIL() << "a faulty solver was used";
    } catch (const InputError& e) {
        const std::string text = e.what();
        EXPECT_NE(text.find("/usr/bin/interFoam"), std::string::npos) << text;
        EXPECT_NE(text.find("FAULTY"), std::string::npos) << text;
        EXPECT_NE(text.find("twinwake setup-openfoam"), std::string::npos) << text;
    }
}

TEST_F(SelfTest, AUsersOwnSoundInstallationIsUsedAsItIs) {
    const OpenFoam sound = sound_openfoam();
    // The layout of openfoam.com's own packages, around the programs that are here.
    const fs::path project = folder / "openfoam9912", bin = project / "platforms/linux64GccDPInt32Opt/bin";
    fs::create_directories(bin);
    fs::create_directories(project / "META-INFO");
    std::ofstream(project / "META-INFO/api-info") << "api=9912\npatch=0\n";
    fs::create_directory_symlink(sound.project_dir / "etc", project / "etc");
    fs::create_symlink(sound.bin / "blockMesh", bin / "blockMesh");
    fs::create_symlink(sound.solver, bin / "interFoam");
    ::setenv("TWINWAKE_OPENFOAM_BIN", "/nowhere", 1);
    ::setenv("HOME", folder.c_str(), 1);
    ::setenv("TWINWAKE_OPENFOAM_PLACES", project.c_str(), 1);
    ::unsetenv("WM_PROJECT_DIR");
    const OpenFoam found = sound_openfoam();
    EXPECT_EQ(found.version, "v9912");
    EXPECT_EQ(found.vendor, "openfoam.com");
    EXPECT_EQ(found.bin, bin);
    EXPECT_EQ(sound_openfoam(project.string()).solver, bin / "interFoam") << "a scene may name it";
}

TEST_F(SelfTest, ASolverThatDoesNotRunIsUnusableAndNotSound) {
    OpenFoam broken = sound_openfoam();
    broken.solver = "/bin/false";
    self_test(broken);
    EXPECT_FALSE(broken.sound);
    EXPECT_NE(broken.verdict.find("unusable"), std::string::npos) << broken.verdict;
    broken.solver = "/bin/true";  // ends well, and has computed nothing
    self_test(broken);
    EXPECT_FALSE(broken.sound);
}

}  // namespace self_test_test
}  // namespace tw

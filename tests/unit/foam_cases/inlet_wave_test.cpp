// A wave that enters with the stream: its numbers in the case, and the library that it needs.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "foam_cases/files/case_files.h"
#include "foam_cases/plan_case.h"
#include "scenes.h"

namespace tw {
namespace inlet_wave_test {

/// A channel in a stream of 3 m/s with a wave 1 m long, which runs at 1.2 m/s.
Scene channel() {
    Scene s;
    s.motion = {Motion::Kind::stream, 3, 0.4};
    s.domain.dimensions = 2;
    s.domain.box = s.domain.undamped = s.domain.as_asked = {Vec3(-2, -0.005, -0.4), Vec3(2.5, 0.005, 0.1)};
    s.domain.x_min = Side::inlet;
    s.domain.x_max = Side::outlet;
    s.domain.y_min = s.domain.y_max = Side::symmetry;
    s.resolution = {0.01, 0.01};
    s.sampling.interval = 0.05;
    s.run.duration = 1;
    s.wave = regular_wave({.height = 0.04, .length = 1, .depth = 0.4, .closed = false, .stream = 3});
    return s;
}

struct Library {
    std::filesystem::path path = std::filesystem::temp_directory_path() / "tw_inlet_wave_test_libforcingZones.so";
    explicit Library(const char* bytes) { write_text_atomically(path, bytes); }
    ~Library() { std::filesystem::remove(path); }
};

OpenFoam installation(const std::filesystem::path& library) {
    OpenFoam found;
    found.vendor = "openfoam.com", found.version = "v1912", found.zone_library = library;
    found.solver = "/own/bin/interFoam", found.bin = "/usr/bin";
    return found;
}

std::string text_of(const CasePlan& plan, const std::string& path) {
    for (const CaseFile& f : case_files(plan, 1))
        if (f.path == path) return f.text;
    return {};
}

double number_in(std::string text, const std::string& name) {
    std::ranges::replace(text, '\n', ' ');
    double value = NAN;
    const std::size_t at = text.find(" " + name + " ");
    if (at != std::string::npos) std::istringstream(text.substr(at + name.size() + 1)) >> value;
    return value;
}

TEST(InletWave, IsConditionsOfTheInletWithTheNumbersThatParticlesTake) {
    const Scene scene = channel();
    const Library library("ELF waveInletFraction");
    const CasePlan plan = plan_case(scene, installation(library.path));
    EXPECT_NE(control_dict(plan).find("(\"" + library.path.string() + "\")"), std::string::npos);
    EXPECT_NE(text_of(plan, "0.orig/U").find("waveInletVelocity"), std::string::npos);
    EXPECT_NE(text_of(plan, "0.orig/alpha.water").find("waveInletFraction"), std::string::npos);
    EXPECT_EQ(text_of(plan, "constant/fvOptions"), "") << "no zones";
    const std::string numbers = text_of(plan, "constant/inletWave");
    const auto number = [&](const std::string& name) { return number_in(numbers, name); };
    EXPECT_NE(numbers.find("(3 0 0)"), std::string::npos) << numbers;
    const RegularWave& wave = *scene.wave;
    EXPECT_NEAR(number("speed"), wave.speed_in_water + 3, 1e-12) << numbers;
    EXPECT_NEAR(number("k"), wave.k(), 1e-12);
    EXPECT_NEAR(number("current"), 3, 1e-12);
    EXPECT_NE(numbers.find("begin           0.4;"), std::string::npos) << "the start-up of the stream";
    EXPECT_NE(numbers.find("ramp"), std::string::npos);
}

// Frequencies are those in the water, and the stream that carries the waves stands beside them.
TEST(InletWave, OfASumHasItsComponentsAndTypesThatAnOlderLibraryDoesNotKnow) {
    Scene scene = channel();
    scene.wave.reset();
    scene.sea = make_sea(
        {.kind = Sea::Kind::bichromatic, .depth = 0.4, .stream = 3, .heights = {0.03, 0.02}, .periods = {0.8, 0.65}});
    const Library library("ELF waveInletFraction waveInletFractionOfASea");
    const CasePlan plan = plan_case(scene, installation(library.path));
    EXPECT_NE(text_of(plan, "0.orig/U").find("waveInletVelocityOfASea"), std::string::npos);
    EXPECT_NE(text_of(plan, "0.orig/alpha.water").find("waveInletFractionOfASea"), std::string::npos);
    const std::string numbers = text_of(plan, "constant/inletWave");
    const WaveComponents& waves = scene.sea->waves;
    for (const auto& [name, values] : {std::pair{"k", waves.k}, {"omega", waves.omega}, {"amplitude", waves.height}}) {
        std::istringstream list(numbers.substr(numbers.find(std::string(" ") + name + " ") + 1));
        list.ignore(1000, '(');
        for (int n = 0; n < 2; ++n) {
            double value = NAN;
            list >> value;
            EXPECT_NEAR(value, values[n], 1e-12) << name << "\n" << numbers;
        }
    }
    EXPECT_EQ(number_in(numbers, "stream"), 3) << numbers;
    EXPECT_EQ(number_in(numbers, "begin"), 0.4);
    EXPECT_NEAR(number_in(numbers, "ramp"), inlet_wave(scene)->ramp, 1e-12);
    const Library older("ELF waveInletFraction");  // in its place
    EXPECT_THROW(plan_case(scene, installation(older.path)), InputError);
}

// A slower stream has zones and the inlet of every stream.
TEST(InletWave, LeavesNothingBehindWhereZonesMakeTheWave) {
    Scene scene = channel();
    scene.motion.speed = 0.8;
    scene.wave = regular_wave({.height = 0.04, .length = 1, .depth = 0.4, .closed = false, .stream = 0.8});
    for (const CaseFile& f : case_files(plan_case(scene, Flavour{}), 1)) {
        EXPECT_EQ(f.text.find("waveInlet"), std::string::npos) << f.path;
        EXPECT_NE(f.path, "constant/inletWave");
    }
}

TEST(InletWave, IsRefusedWithoutALibraryThatKnowsIt) {
    const Scene scene = channel();
    const Library old("ELF forcingZones");
    for (const std::filesystem::path& library : {std::filesystem::path(), old.path, old.path / "none"}) try {
            plan_case(scene, installation(library));
            ADD_FAILURE() << library << " was taken";
        } catch (const InputError& e) {
            const std::string text = e.what();
            for (const char* part : {"waves that enter with the stream", "twinwake setup-openfoam builds it"})
                EXPECT_NE(text.find(part), std::string::npos) << text;
        }
}

}  // namespace inlet_wave_test
}  // namespace tw

// What a run writes while it goes on is what it would have written standing still.
#include "sph_solver/run_files.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <map>
#include <optional>

#include "base/atomic_file.h"
#include "meshes/generate.h"
#include "motion/rigid_mass.h"

namespace tw {
namespace run_files_test {

namespace fs = std::filesystem;

class Folder {
public:
    explicit Folder(const std::string& name)
        : path_(fs::temp_directory_path() / fs::path("run_files_" + name + std::to_string(getpid()))) {
        fs::remove_all(path_);
        fs::create_directory(path_);
    }
    ~Folder() { fs::remove_all(path_); }
    const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

/// A column that falls on a box that floats, with a hull and a raster that are made up.
struct Falls {
    Simulation simulation = falling();
    RunRecord record;

    Falls() {
        record.raster = {{0, 0, 0}, 0.1, {10, 3, 10}};
        record.hull = box_surface({Vec3(0, 0, 0), Vec3(1, 1, 1)});
        record.hull_pressure.assign(record.hull.triangles.size(), 5);
        record.hull_wet.assign(record.hull.triangles.size(), 1);
    }
    static Simulation falling() {
        SimulationSetup s;
        s.dp = 0.05;
        s.state_equation.c0 = 30;
        s.domain = {Vec3(0, 0, 0), Vec3(1, 0.3, 1)};
        s.mirrors.on = {{{true, true}, {true, true}, {true, false}}};
        s.bodies = {box_surface({Vec3(0.6, 0.05, 0.3), Vec3(0.8, 0.25, 0.5)})};
        s.bodies[0].moving.emplace();
        s.bodies[0].moving->mass = solid_mass(s.bodies[0].surface, 500);
        s.threads = 1;
        return Simulation(s, fill_with_fluid(s, {Box{Vec3(0, 0, 0), Vec3(1, 0.3, 0.2)}}));
    }
    /// Steps, and what is to be written then.
    RunOutput next() {
        for (int k = 0; k < 3; ++k) simulation.step();
        record.table("samples").append(simulation.time());
        RasterFrame frame{simulation.time(), std::vector<std::uint8_t>(300, 0)};
        std::fill_n(frame.water.begin(), 120 + 30 * record.frames.size(), 255);
        record.frames.push_back(frame);
        return {picture_of(simulation, record), record, checkpoint_of(simulation, 1)};
    }
};

std::map<std::string, std::string> contents(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) files[entry.path().lexically_relative(folder)] = read_text(entry.path());
    return files;
}

std::map<std::string, std::string> written(const std::string& name, bool beside_steps) {
    const Folder folder(name);
    Falls run;
    RunFiles files(folder.path(), "a scene", Comm::alone(), beside_steps);
    for (int k = 0; k < 3; ++k) files.write(run.next());  // the next steps are made while it writes
    files.finish();
    return contents(folder.path());
}

TEST(RunFiles, BesideTheStepsAreThoseOfARunThatWaits) {
    const auto waiting = written("waiting", false), beside = written("beside", true);
    // record, checkpoint; three each of particles, body, hull and water's surface, and their series
    EXPECT_EQ(waiting.size(), 2u + 4 * (3 + 1));
    for (const auto& [name, bytes] : waiting) EXPECT_TRUE(beside.contains(name) && beside.at(name) == bytes) << name;
    EXPECT_EQ(beside.size(), waiting.size());
}

TEST(RunFiles, SayWhatKeptThemFromBeingWrittenAtTheNextOutputOrTheEnd) {
    const auto failure = [](const char* name, bool beside_steps, bool at_end) -> std::string {
        std::optional<Folder> folder(name);
        const fs::path was = folder->path();
        Falls run;
        RunFiles files(was, "a scene", Comm::alone(), beside_steps);
        files.write(run.next());
        files.finish();
        folder.reset();  // somebody removes it
        try {
            files.write(run.next());
            if (at_end)
                files.finish();
            else
                files.write(run.next());
        } catch (const std::exception& e) {
            EXPECT_FALSE(fs::exists(was)) << "a folder was made that somebody has removed";
            return e.what();
        }
        return {};
    };
    const std::string waiting = failure("gone", false, true);
    EXPECT_NE(waiting.find("snapshots"), std::string::npos) << waiting;
    EXPECT_EQ(failure("gone", true, true), waiting);
    EXPECT_EQ(failure("gone", true, false), waiting);
}

}  // namespace run_files_test
}  // namespace tw

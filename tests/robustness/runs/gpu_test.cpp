// The program with a GPU, or none, as a user meets it; the GPU is the driver without a device of tests/fake_cuda.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>

#include "base/atomic_file.h"
#include "program.h"
#include "record/run_record.h"
#include "test_paths.h"

namespace tw::test {
namespace gpu_test {

namespace fs = std::filesystem;

class Gpu : public testing::Test {
protected:
    void SetUp() override { setenv("TWINWAKE_LIBCUDA", TWINWAKE_FAKE_CUDA, 1); }
    void TearDown() override { unsetenv("TWINWAKE_LIBCUDA"), unsetenv("FAKE_CUDA"), unsetenv("TWINWAKE_ISA"); }
};

const fs::path scene = fs::path(TWINWAKE_SOURCE) / "tests/robustness/runs/small_planing.toml";

struct Ended {
    int status;
    std::string output;
};
Ended run(const fs::path& folder, const std::string& out, const std::vector<std::string>& more,
          const fs::path& of = scene) {
    std::vector<std::string> words{
        "run", of.string(), "--no-twins", "--method", "sph", "--out", (folder / out).string(), "--threads", "1"};
    words.insert(words.end(), more.begin(), more.end());
    Program program(words, folder);
    const int status = program.wait();
    return {status, program.output()};
}

/// The GPU's record of a run, of which a table is the same as the emulated variant's.
RunRecord same_table(const std::string& table, const std::vector<std::string>& more, const fs::path& of = scene) {
    const ScratchFolder folder("gpu");
    setenv("TWINWAKE_ISA", "device_emulated", 1);
    std::vector<std::string> on_host{"--device", "cpu"}, on_gpu{"--device", "gpu"};
    on_host.insert(on_host.end(), more.begin(), more.end()), on_gpu.insert(on_gpu.end(), more.begin(), more.end());
    const Ended host = run(folder.path(), "host", on_host, of), gpu = run(folder.path(), "gpu", on_gpu, of);
    EXPECT_EQ(host.status, 0) << host.output;
    EXPECT_EQ(gpu.status, 0) << gpu.output;
    RunRecord a = read_record(folder.path() / "host/sph/record.h5"),
              b = read_record(folder.path() / "gpu/sph/record.h5");
    EXPECT_EQ(b.attributes["device"], "Emulated device");
    for (const Column& column : b.table(table).columns) {
        const Column* same = a.table(table).find(column.name);
        EXPECT_TRUE(same) << column.name;
        for (std::size_t k = 0; same && k < column.values.size(); ++k)
            if (!std::isnan(column.values[k])) {
                EXPECT_EQ(column.values[k], same->values[k]) << column.name << " " << k;
            }
    }
    return b;
}

TEST_F(Gpu, MakesTheStepsOfARunWhoseRecordIsThatOfTheEmulatedVariant) {
    RunRecord record = same_table("forces", {"--duration", "0.06 s"});
    EXPECT_GT(record.table("forces").time.size(), 10u);
}

/// The files of a run, but for its record, which holds times of the clock.
std::map<std::string, std::string> pictures_in(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::directory_iterator(folder)) files[entry.path().filename()] = read_text(entry.path());
    return files;
}

// A device makes the next steps while a thread writes; the host stands still.
TEST_F(Gpu, WritesBesideItsStepsWhatTheHostWritesBetweenThem) {
    const ScratchFolder folder("gpu_pictures");
    const std::string interval = "interval = \"0.05 s\"";
    std::string text = read_text(scene);
    text.replace(text.find(interval), interval.size(), "interval = 0.01\nsnapshots = 0.01");
    write_text_atomically(folder.path() / "scene.toml", text);
    setenv("TWINWAKE_ISA", "device_emulated", 1);
    for (const char* device : {"cpu", "gpu"}) {
        const Ended ended =
            run(folder.path(), device, {"--device", device, "--duration", "0.05 s"}, folder.path() / "scene.toml");
        EXPECT_EQ(ended.status, 0) << ended.output;
    }
    const auto host = pictures_in(folder.path() / "cpu/sph/snapshots"),
               gpu = pictures_in(folder.path() / "gpu/sph/snapshots");
    EXPECT_GE(host.size(), 3 * 5u);  // particles, hull, water's surface
    for (const auto& [name, bytes] : host) EXPECT_TRUE(gpu.contains(name) && gpu.at(name) == bytes) << name;
    EXPECT_EQ(gpu.size(), host.size());
}

TEST_F(Gpu, OnAFullDiskSaysSoAndLeavesNoHalfWrittenFile) {
    const ScratchFolder folder("gpu_disk_full");
    Program full({"run", scene.string(), "--no-twins", "--method", "sph", "--out", (folder.path() / "run").string(),
                  "--threads", "1", "--device", "gpu"},
                 folder.path(), 20'000);
    EXPECT_EQ(full.wait(), 3) << full.output();
    EXPECT_NE(full.output().find(".h5: cannot be written"), std::string::npos) << full.output();
    for (const auto& entry : fs::recursive_directory_iterator(folder.path() / "run"))
        EXPECT_EQ(entry.path().string().find(".tmp"), std::string::npos) << "left behind: " << entry.path();
}

TEST_F(Gpu, AlsoOfWaterThatRubsOnTheHull) {
    RunRecord record =
        same_table("forces", {"--duration", "0.04 s", "--effect", "viscosity=on", "--effect", "turbulence=on"});
    const Column* friction = record.table("forces").find("fx_viscous");
    ASSERT_TRUE(friction);
    EXPECT_NE(friction->values.back(), 0);
}

TEST_F(Gpu, AlsoOfATankThatSways) {
    const fs::path sloshing = fs::path(TWINWAKE_SOURCE) / "studies/sloshing.toml";
    RunRecord record = same_table("tank", {"--near-hull", "16mm", "--duration", "0.1s"}, sloshing);
    EXPECT_NE(record.table("tank").find("fx")->values.back(), 0);
}

TEST_F(Gpu, AlsoOfWaterBehindAGateThatBends) {
    const fs::path gate = fs::path(TWINWAKE_SOURCE) / "studies/elastic_gate.toml";
    RunRecord record = same_table(body_table("gate"), {"--near-hull", "2.5mm", "--duration", "0.02s"}, gate);
    const Column* tip = record.table(body_table("gate")).find("tip_x");
    ASSERT_TRUE(tip);
    EXPECT_NE(tip->values.back(), 0);
}

TEST_F(Gpu, AlsoOfAirThatBreakingWaterShutsIn) {
    const fs::path pocket = fs::path(TWINWAKE_SOURCE) / "studies/pocket.toml";
    RunRecord record =
        same_table("samples", {"--near-hull", "40mm", "--duration", "0.05s", "--effect", "air=on"}, pocket);
    const Column* speed = record.table("samples").find("air_max_speed");
    ASSERT_TRUE(speed);
    EXPECT_GT(speed->values.back(), 0);
}

TEST_F(Gpu, CheckSaysWhatOfItsMemoryASceneTakes) {
    const auto said = [](const char* study, std::vector<std::string> more) {
        const ScratchFolder folder("gpu_check");
        more.insert(more.begin(), {"check", (fs::path(TWINWAKE_SOURCE) / "studies" / study).string()});
        Program program(more, folder.path());
        EXPECT_EQ(program.wait(), 0) << program.output();
        const std::string text = program.output();
        const std::size_t at = text.find("gpu: ");
        return at == std::string::npos ? text : text.substr(at, text.find('\n', at) - at);
    };
    EXPECT_NE(said("sloshing.toml", {"--effect", "viscosity=on"}).find("one can make"), std::string::npos);
    EXPECT_NE(said("elastic_gate.toml", {}).find("one can make"), std::string::npos);
}

TEST_F(Gpu, ThatIsNotThereIsSaidAndAutoGoesOnWithout) {
    const ScratchFolder folder("gpu_none");
    setenv("TWINWAKE_LIBCUDA", "/nowhere/libcuda.so.1", 1);
    const Ended asked = run(folder.path(), "gpu", {"--device", "gpu"});
    EXPECT_EQ(asked.status, 2) << asked.output;
    EXPECT_NE(asked.output.find("no driver was found"), std::string::npos) << asked.output;
    EXPECT_FALSE(fs::exists(folder.path() / "gpu"));
    // the runs of a study that is handed over are made elsewhere
    const Ended elsewhere = run(folder.path(), "elsewhere", {"--device", "gpu", "--emit", "snakemake"});
    EXPECT_EQ(elsewhere.status, 0) << elsewhere.output;
    const Ended automatic = run(folder.path(), "auto", {"--device", "auto", "--duration", "0.05 s"});
    EXPECT_EQ(automatic.status, 0) << automatic.output;
    EXPECT_EQ(read_record(folder.path() / "auto/sph/record.h5").attributes.contains("device"), false);
}

// The first prediction for a GPU measures it; later ones know.
TEST_F(Gpu, IsTimedOnceAndTestedByDoctor) {
    const ScratchFolder folder("gpu_pace");
    setenv("XDG_CACHE_HOME", folder.path().c_str(), 1);
    Program check({"check", scene.string(), "--device", "gpu"}, folder.path());
    EXPECT_EQ(check.wait(), 0) << check.output();
    const fs::path file = folder.path() / "twinwake/pace.json";
    const std::string measured = read_text(file);
    EXPECT_NE(measured.find("bench of sph on Emulated device"), std::string::npos) << measured;
    Program again({"check", scene.string(), "--device", "gpu"}, folder.path());
    EXPECT_EQ(again.wait(), 0) << again.output();
    EXPECT_EQ(read_text(file), measured);
    Program doctor({"doctor"}, folder.path());
    doctor.wait();
    EXPECT_NE(doctor.output().find("Emulated device"), std::string::npos) << doctor.output();
    EXPECT_NE(doctor.output().find("sound: error 0."), std::string::npos) << doctor.output();
    unsetenv("XDG_CACHE_HOME");
}

TEST_F(Gpu, WithTooLittleMemoryIsSaidBeforeTheRunBegins) {
    const ScratchFolder folder("gpu_full");
    setenv("FAKE_CUDA", "memory=200000", 1);
    const Ended full = run(folder.path(), "run", {"--device", "gpu"});
    EXPECT_EQ(full.status, 2) << full.output;
    EXPECT_NE(full.output.find("0.0002 GB free"), std::string::npos) << full.output;
    EXPECT_NE(full.output.find("[run] device = \"cpu\""), std::string::npos) << full.output;
}

TEST_F(Gpu, WithTooLittleMemoryIsLeftAloneByAuto) {
    const ScratchFolder folder("gpu_small");
    setenv("FAKE_CUDA", "memory=200000", 1);
    const Ended small = run(folder.path(), "run", {"--device", "auto", "--duration", "0.01 s"});
    EXPECT_EQ(small.status, 0) << small.output;
    const std::string said = "GPU: left alone: Emulated device has 0.0002 GB of memory, and ";
    EXPECT_NE(small.output.find(said), std::string::npos) << small.output;
    EXPECT_NE(small.output.find("; this processor makes the steps"), std::string::npos) << small.output;
    EXPECT_FALSE(read_record(folder.path() / "run/sph/record.h5").attributes.contains("device"));
    setenv("FAKE_CUDA", "memory=200000000", 1);
    const Ended large = run(folder.path(), "large", {"--device", "auto", "--duration", "0.01 s"});
    EXPECT_EQ(large.status, 0) << large.output;
    EXPECT_EQ(large.output.find("left alone"), std::string::npos) << large.output;
    EXPECT_TRUE(read_record(folder.path() / "large/sph/record.h5").attributes.contains("device"));
    setenv("FAKE_CUDA", "memory=200000000 others=199900000", 1);  // a run of somebody else
    const Ended full = run(folder.path(), "full", {"--device", "auto", "--duration", "0.01 s"});
    EXPECT_EQ(full.status, 0) << full.output;
    RunRecord record = read_record(folder.path() / "full/sph/record.h5");
    EXPECT_FALSE(record.attributes.contains("device"));
    EXPECT_NE(record.attributes["gpu_left_alone"].find("has 0.0001 GB free"), std::string::npos);
}

TEST_F(Gpu, OfSeveralTheFirstThatCanIsTakenAndNamed) {
    const ScratchFolder folder("gpu_two");
    setenv("FAKE_CUDA", "two_devices", 1);
    const Ended two = run(folder.path(), "run", {"--device", "gpu", "--duration", "0.01 s"});
    EXPECT_EQ(two.status, 0) << two.output;
    EXPECT_NE(two.output.find("Emulated device"), std::string::npos) << two.output;
    EXPECT_NE(two.output.find("number 2 of 2, the first that can be used"), std::string::npos) << two.output;
}

TEST_F(Gpu, LostInTheMiddleFailsTheRunWhichGoesOnWithoutIt) {
    const ScratchFolder folder("gpu_lost");
    setenv("FAKE_CUDA", "lost_after=3000", 1);
    const Ended lost = run(folder.path(), "run", {"--device", "gpu", "--duration", "0.15 s"});
    EXPECT_EQ(lost.status, 3) << lost.output;
    EXPECT_NE(lost.output.find("unspecified launch failure"), std::string::npos) << lost.output;
    const Ended resumed = run(folder.path(), "run", {"--device", "cpu", "--resume", "--duration", "0.15 s"});
    EXPECT_EQ(resumed.status, 0) << resumed.output;
    EXPECT_EQ(read_record(folder.path() / "run/sph/record.h5").state, "finished");
}

}  // namespace gpu_test
}  // namespace tw::test

#include <gtest/gtest.h>

#include "base/folder_lock.h"
#include "program.h"
#include "record/run_record.h"

namespace tw::test {
namespace one_folder_test {

TEST(OneFolder, SecondRunIsRefusedAndFirstIsUnharmed) {
    const ScratchFolder folder("one_folder");
    const auto scene = write_small_scene(folder.path() / "scene.toml", 0.4);
    const auto out = folder.path() / "run";
    Program first({"run", scene.string(), "--no-twins", "--method", "sph", "--out", out.string()}, folder.path());
    ASSERT_TRUE(wait_until([&] { return std::filesystem::exists(out / "sph" / "checkpoint.h5"); }, 60))
        << first.output();

    Program second({"run", scene.string(), "--no-twins", "--method", "sph", "--out", out.string(), "--overwrite"},
                   folder.path());
    EXPECT_EQ(second.wait(), 2);
    EXPECT_NE(second.output().find("another run"), std::string::npos) << second.output();
    ASSERT_TRUE(first.running()) << "the first run ended too early for this test to see anything";

    EXPECT_EQ(first.wait(), 0) << first.output();
    EXPECT_EQ(read_record(out / "sph" / "record.h5").state, "finished");
}

TEST(OneFolder, FinishedRunIsNotOverwrittenUnasked) {
    const ScratchFolder folder("finished");
    const auto scene = write_small_scene(folder.path() / "scene.toml", 0.05);
    const std::vector<std::string> command{
        "run", scene.string(), "--no-twins", "--method", "sph", "--out", (folder.path() / "run").string()};
    ASSERT_EQ(Program(command, folder.path()).wait(), 0);
    const auto record = folder.path() / "run" / "sph" / "record.h5";
    const auto written = std::filesystem::last_write_time(record);
    EXPECT_EQ(Program(command, folder.path()).wait(), 2);
    EXPECT_EQ(std::filesystem::last_write_time(record), written);
    auto overwrite = command;
    overwrite.push_back("--overwrite");
    EXPECT_EQ(Program(overwrite, folder.path()).wait(), 0);
    EXPECT_NE(std::filesystem::last_write_time(record), written);
}

TEST(OneFolder, AStudyIsHeldAsAWhole) {
    const ScratchFolder folder("study");
    const auto scene = write_small_scene(folder.path() / "scene.toml", 0.05), out = folder.path() / "run";
    const FolderLock other(out);
    for (const char* command : {"run", "ladder", "sweep", "ablate"}) {
        Program study({command, scene.string(), "--out", out.string(), "--overwrite"}, folder.path());
        EXPECT_EQ(study.wait(), 2) << command;
        EXPECT_NE(study.output().find("another run"), std::string::npos) << command << ": " << study.output();
    }
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(out), {}), 1) << "more than the lock is there";
}

}  // namespace one_folder_test
}  // namespace tw::test

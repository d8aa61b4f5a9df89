#include <gtest/gtest.h>

#include "base/errors.h"
#include "program.h"
#include "record/run_record.h"

namespace tw::test {
namespace disk_full_test {

// No file may grow beyond the limit: write() fails in the middle of a file, as on a full disk.
TEST(DiskFull, RunSaysSoAndLeavesNoHalfWrittenFile) {
    const ScratchFolder folder("disk_full");
    const auto scene = write_small_scene(folder.path() / "scene.toml", 0.3);
    const auto out = folder.path() / "run";
    Program run({"run", scene.string(), "--no-twins", "--method", "sph", "--out", out.string()}, folder.path(), 20'000);
    EXPECT_EQ(run.wait(), 3) << run.output();
    EXPECT_NE(run.output().find(".h5"), std::string::npos) << "the message names the file\n" << run.output();
    for (const auto& entry : std::filesystem::recursive_directory_iterator(out)) {
        if (entry.path().filename() == "record.h5") { EXPECT_NO_THROW(read_record(entry.path())); }
        EXPECT_EQ(entry.path().string().find(".tmp"), std::string::npos) << "left behind: " << entry.path();
    }
    // With room on the disk again the same command with --overwrite runs to its end.
    Program again({"run", scene.string(), "--no-twins", "--method", "sph", "--out", out.string(), "--overwrite"},
                  folder.path());
    EXPECT_EQ(again.wait(), 0) << again.output();
}

TEST(DiskFull, FolderThatCannotBeMadeIsAnInputError) {
    const ScratchFolder folder("no_folder");
    const auto scene = write_small_scene(folder.path() / "scene.toml", 0.1);
    Program run({"run", scene.string(), "--no-twins", "--method", "sph", "--out", (scene / "run").string()},
                folder.path());
    EXPECT_EQ(run.wait(), 2) << run.output();
    EXPECT_NE(run.output().find(scene.string()), std::string::npos) << run.output();
}

}  // namespace disk_full_test
}  // namespace tw::test

// Run records with a byte changed or an end missing: refused by name, or read as they were written.
#include <gtest/gtest.h>

#include <optional>
#include <random>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "tests/unit/record/example_record.h"

namespace tw {
namespace damaged_records_test {

class DamagedRecords : public testing::Test {
protected:
    ScratchFolder folder;
    std::string written = [this] {
        write_record(folder / "record.h5", example_record());
        return read_text(folder / "record.h5");
    }();
    /// What HDF5 itself has to see: without the line of the whole file's checksum, as after a copy by another program.
    std::string hdf5 = written.substr(0, written.rfind("\ntwinwake sha256 "));

    /// Reads the bytes as a record and writes what was read; nothing where they were refused. A refusal names the file.
    std::optional<std::string> read_and_written(const std::string& bytes) {
        write_text_atomically(folder / "bad.h5", bytes);
        try {
            write_record(folder / "again.h5", read_record(folder / "bad.h5"));
        } catch (const InputError& e) {
            EXPECT_NE(std::string(e.what()).find("bad.h5: "), std::string::npos) << e.what();
            return {};
        }
        return read_text(folder / "again.h5");
    }
};

TEST_F(DamagedRecords, AFlippedByteNeverGivesOtherNumbers) {
    ASSERT_EQ(read_and_written(hdf5), written);
    std::mt19937 random(1);
    int refused = 0;
    constexpr int tries = 150;
    for (int i = 0; i < tries; ++i) {
        std::string bad = hdf5;
        const std::size_t at = random() % bad.size();
        bad[at] = static_cast<char>(bad[at] ^ (1 + random() % 255));
        const auto again = read_and_written(bad);
        refused += !again;
        EXPECT_TRUE(!again || *again == written) << "byte " << at << " of " << bad.size();
    }
    EXPECT_GT(refused, tries * 3 / 4) << "too few to have hit anything that counts";
}

TEST_F(DamagedRecords, EveryByteOfTheMetadataIsCovered) {
    // The first kilobytes hold the superblock, the root's header with its attributes, and groups.
    for (std::size_t at = 0; at < 4096; at += 31) {
        std::string bad = hdf5;
        bad[at] = static_cast<char>(bad[at] ^ 0x10);
        const auto again = read_and_written(bad);
        EXPECT_TRUE(!again || *again == written) << "byte " << at;
    }
}

TEST_F(DamagedRecords, ACutOffEndIsRefused) {
    std::mt19937 random(2);
    for (int i = 0; i < 100; ++i) EXPECT_FALSE(read_and_written(hdf5.substr(0, random() % hdf5.size())));
}

TEST_F(DamagedRecords, AFilledBlockIsRefused) {
    // A sector of zeros, as a disk or a copy can leave it.
    for (std::size_t at = 512; at + 512 < hdf5.size(); at += 4096) {
        std::string bad = hdf5;
        bad.replace(at, 512, std::string(512, '\0'));
        const auto again = read_and_written(bad);
        EXPECT_TRUE(!again || *again == written) << "block at " << at;
    }
}

}  // namespace damaged_records_test
}  // namespace tw

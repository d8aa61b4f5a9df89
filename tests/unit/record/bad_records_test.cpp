#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <random>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "base/numbers.h"
#include "tests/unit/record/example_record.h"

namespace tw {
namespace bad_records_test {

/// The message of the InputError that reading throws; empty when it reads.
std::string refusal(const std::filesystem::path& file) {
    try {
        read_record(file);
    } catch (const InputError& e) { return e.what(); }
    return {};
}
bool says(const std::string& message, const std::string& part) { return message.find(part) != std::string::npos; }

TEST(BadRecords, EachFaultIsNamedWithTheFile) {
    const ScratchFolder folder;
    EXPECT_TRUE(says(refusal(folder / "none.h5"), "none.h5: there is no such run record"));
    EXPECT_TRUE(says(refusal(folder.path()), "is a folder"));
    ASSERT_EQ(mkfifo((folder / "pipe.h5").c_str(), 0600), 0);
    EXPECT_TRUE(says(refusal(folder / "pipe.h5"), "is not a file"));
    write_text_atomically(folder / "empty.h5", "");
    EXPECT_TRUE(says(refusal(folder / "empty.h5"), "not an HDF5 file (0 bytes)"));
    write_text_atomically(folder / "text.h5", "solid hull\nendsolid\n");
    EXPECT_TRUE(says(refusal(folder / "text.h5"), "not an HDF5 file"));
    const hid_t other = H5Fcreate((folder / "other.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    H5Fclose(other);
    EXPECT_TRUE(says(refusal(folder / "other.h5"), "not a run record of twinwake"));
}

/// The record as another version would leave it: changed, and without the checksum line that would contradict that.
template <class Change>
std::filesystem::path otherwise(const ScratchFolder& folder, Change change) {
    write_record(folder / "record.h5", example_record());
    const std::string bytes = read_text(folder / "record.h5");
    const std::filesystem::path path = folder / "other.h5";
    write_text_atomically(path, bytes.substr(0, bytes.rfind("\ntwinwake sha256 ")));
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    change(file);
    H5Fclose(file);
    return path;
}
void set_version(hid_t file, double version) {
    const hid_t attribute = H5Aopen(file, "format_version", H5P_DEFAULT);
    ASSERT_GE(H5Awrite(attribute, H5T_NATIVE_DOUBLE, &version), 0);
    H5Aclose(attribute);
}

TEST(BadRecords, ANewerFormatAsksForANewerTwinwake) {
    const ScratchFolder folder;
    const auto path = otherwise(folder, [](hid_t file) { set_version(file, 2); });
    EXPECT_TRUE(says(refusal(path), "format 2"));
    EXPECT_TRUE(says(refusal(path), "newer twinwake"));
}

TEST(BadRecords, AFormatThatNeverWasIsDamage) {
    const ScratchFolder folder;
    EXPECT_TRUE(says(refusal(otherwise(folder, [](hid_t file) { set_version(file, 0); })), "the first was 1"));
}

TEST(BadRecords, ARecordFromBeforeValidityChecksAndResolutionIsRead) {
    const ScratchFolder folder;
    ASSERT_FALSE(example_record().validity_checks.empty());
    ASSERT_FALSE(example_record().resolution.empty());
    const auto path = otherwise(folder, [](hid_t file) {
        for (const char* group : {"certificate", "resolution"}) ASSERT_GE(H5Ldelete(file, group, H5P_DEFAULT), 0);
    });
    const RunRecord old = read_record(path);
    EXPECT_TRUE(old.validity_checks.empty());
    EXPECT_TRUE(old.resolution.empty());
    EXPECT_EQ(old.tables.size(), example_record().tables.size());
}

TEST(BadRecords, CutOffAnywhereIsRefused) {
    const ScratchFolder folder;
    write_record(folder / "record.h5", example_record());
    const std::string bytes = read_text(folder / "record.h5");
    // From "only the checksum line is missing its last byte" down to nothing. Cut exactly behind the HDF5 part the data
    // are whole, and the file reads.
    const std::size_t whole = bytes.rfind("\ntwinwake sha256 ");
    for (std::size_t keep = 0; keep < whole; keep += 1 + whole / 97) {
        write_text_atomically(folder / "cut.h5", bytes.substr(0, keep));
        EXPECT_NE(refusal(folder / "cut.h5"), "") << keep << " of " << bytes.size();
    }
    write_text_atomically(folder / "cut.h5", bytes.substr(0, whole));
    EXPECT_EQ(refusal(folder / "cut.h5"), "");
}

TEST(BadRecords, AnyFlippedByteIsRefused) {
    const ScratchFolder folder;
    write_record(folder / "record.h5", example_record());
    const std::string bytes = read_text(folder / "record.h5");
    std::mt19937 random(1);
    for (int i = 0; i < 50; ++i) {
        std::string bad = bytes;
        const std::size_t at = random() % (bytes.size() - 100);
        bad[at] = static_cast<char>(bad[at] ^ (1 << (random() % 8)));
        write_text_atomically(folder / "bad.h5", bad);
        EXPECT_NE(refusal(folder / "bad.h5"), "") << "byte " << at;
    }
}

TEST(BadRecords, ADamagedArrayIsNamed) {
    const ScratchFolder folder;
    write_record(folder / "record.h5", example_record());
    const std::string bytes = read_text(folder / "record.h5");
    // The scene's text is stored as it is: a byte in its middle is a byte of that array.
    std::string bad = bytes;
    ++bad[bytes.find("########") + 50000];
    write_text_atomically(folder / "bad.h5", bad);
    EXPECT_TRUE(says(refusal(folder / "bad.h5"),
                     "bad.h5: cut off or damaged: dataset scene_text: checksum does not match: the file is damaged"))
        << refusal(folder / "bad.h5");
}

/// What reading says of the example with one thing changed.
template <class Change>
std::string refusal_of(Change change) {
    const ScratchFolder folder;
    RunRecord record = example_record();
    change(record);
    write_record(folder / "record.h5", record);
    return refusal(folder / "record.h5");
}

TEST(BadRecords, ScalarsThatCannotBeAreRefusedByTheirKey) {
    const auto expect = [](const std::string& message, const std::string& key) {
        EXPECT_TRUE(says(message, "record.h5: " + key)) << key << ": " << message;
    };
    ASSERT_EQ(refusal_of([](RunRecord&) {}), "");
    expect(refusal_of([&](RunRecord& r) { r.numbers["third"] = nan; }),
           "numbers/third = nan; expected a finite number");
    expect(refusal_of([&](RunRecord& r) { r.numbers["speed"] = -8; }), "numbers/speed = -8; expected");
    expect(refusal_of([&](RunRecord& r) { r.numbers["gravity"] = -1; }), "numbers/gravity = -1; expected");
    expect(refusal_of([&](RunRecord& r) { r.numbers["duration"] = 0; }), "numbers/duration = 0; expected");
    expect(refusal_of([&](RunRecord& r) { r.elements = -1; }), "cost/elements = -1; expected");
    expect(refusal_of([&](RunRecord& r) { r.steps = infinite; }), "cost/steps = inf; expected");
    expect(refusal_of([&](RunRecord& r) { r.peak_memory = nan; }), "cost/peak_memory = nan; expected");
    expect(refusal_of([&](RunRecord& r) { r.phases[1].wall = -2; }), "cost/solving/wall = -2; expected");
    expect(refusal_of([&](RunRecord& r) { r.table("forces").time[3] = infinite; }),
           "tables/forces/time[3] = inf; expected");
    expect(refusal_of([&](RunRecord& r) { r.table("forces").time[3] = -1; }), "tables/forces/time[3] = -1; expected");
    expect(refusal_of([&](RunRecord& r) { r.frames[2].time = 0.1; }), "raster/time[2] = 0.1; expected");
    expect(refusal_of([&](RunRecord& r) { r.raster.voxel = nan; }), "raster/spacing = nan; expected");
    expect(refusal_of([&](RunRecord& r) { r.hull.points[1].y() = infinite; }), "hull/points = inf; expected");
    expect(refusal_of([&](RunRecord& r) { r.bodies[0].surface.points[1].y() = infinite; }),
           "bodies/body_torpedo/points = inf; expected");
    expect(refusal_of([&](RunRecord& r) { r.bodies[1].centre.x() = nan; }), "bodies/body_buoy/centre = nan; expected");
    EXPECT_TRUE(says(refusal_of([](RunRecord& r) { r.bodies[1].surface.triangles[0][2] = 4; }),
                     "body_buoy: a triangle names a point that is not there"));
    expect(refusal_of([&](RunRecord& r) { r.effects[0].cost = nan; }), "effects/air/cost = nan; expected");
    expect(refusal_of([&](RunRecord& r) { r.validity_checks[0].limit = nan; }), "certificate/Mach number/limit = nan");
    expect(refusal_of([&](RunRecord& r) { r.validity_checks[0].time = infinite; }),
           "certificate/Mach number/time = inf");
    expect(refusal_of([&](RunRecord& r) { r.validity_checks[0].value = nan; }), "certificate/Mach number/value = nan");
    expect(refusal_of([&](RunRecord& r) { r.resolution[1].size = 0; }), "resolution/size = 0; expected");
    expect(refusal_of([&](RunRecord& r) { r.resolution[1].box.max.z() = infinite; }), "resolution/box = inf; expected");
    EXPECT_EQ(refusal_of([&](RunRecord& r) { r.validity_checks[0].value = nan, r.state = "failed"; }), "")
        << "what a run failed of may be no number";
}

TEST(BadRecords, AFullDiskLeavesTheOldFile) {
    const ScratchFolder folder;
    RunRecord first = example_record();
    first.reason = "the old one";
    write_record(folder / "record.h5", first);

    // Like a full disk: files may not grow beyond 4 kB, and the system says so instead of killing us.
    rlimit old_limit{};
    getrlimit(RLIMIT_FSIZE, &old_limit);
    const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{4096, old_limit.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    std::string message;
    try {
        write_record(folder / "record.h5", example_record());
    } catch (const RunError& e) { message = e.what(); }
    setrlimit(RLIMIT_FSIZE, &old_limit);
    std::signal(SIGXFSZ, old_handler);

    EXPECT_TRUE(says(message, "record.h5: cannot be written")) << message;
    EXPECT_EQ(read_record(folder / "record.h5").reason, "the old one");
    EXPECT_FALSE(std::filesystem::exists(folder / "record.h5.tmp"));
}

}  // namespace bad_records_test
}  // namespace tw

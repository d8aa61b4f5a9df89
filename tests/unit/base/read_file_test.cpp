#include "base/read_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <new>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "base/in_words.h"

namespace tw {
namespace read_file_test {
namespace fs = std::filesystem;

std::string said(const std::function<void()>& work) {
    try {
        work();
    } catch (const std::exception& e) { return in_words(e); }
    return "nothing";
}

TEST(ReadText, ComesToAnEndAndSaysWhatWasFound) {
    EXPECT_EQ(said([] { read_text("/dev/zero"); }), "/dev/zero: cannot be read: it is a device; expected a file");
    EXPECT_EQ(said([] { read_text("/tmp"); }), "/tmp: cannot be read: it is a folder; expected a file");
    EXPECT_EQ(said([] { read_text("/tmp/no such file"); }),
              "/tmp/no such file: cannot be read: No such file or directory");
    const fs::path file = fs::temp_directory_path() / ("read_file_" + std::to_string(::getpid()));
    write_text_atomically(file, std::string(1000, 'x'));
    EXPECT_EQ(read_text_within(file, 1000).size(), 1000u);
    EXPECT_NE(said([&] { read_text_within(file, 999); }).find("it has more than"), std::string::npos);
    fs::remove(file);
}

TEST(OwnFolder, IsNotMadeThroughASymbolicLink) {
    const fs::path base = fs::temp_directory_path() / ("own_folder_" + std::to_string(::getpid()));
    fs::create_directories(base / "elsewhere");
    fs::create_directory_symlink(base / "elsewhere", base / "figures");
    EXPECT_EQ(said([&] { make_own_folder(base / "figures"); }).find((base / "figures").string() + ": is a symbolic"),
              0);
    EXPECT_NO_THROW(make_own_folder(base / "report/figures"));
    EXPECT_NO_THROW(make_own_folder(base / "report/figures")) << "it is there";
    fs::remove_all(base);
}

TEST(InWords, NoLibrarySpeaksForItself) {
    EXPECT_EQ(said([] { fs::create_directory("/proc/nothing/of/the/kind"); }),
              "/proc/nothing/of/the/kind: No such file or directory");
    EXPECT_EQ(said([] { ADD_FAILURE() << nlohmann::json::parse("{"); }).find("parse error at line 1"), 0u);
    EXPECT_EQ(said([] { throw std::bad_alloc(); }), "out of memory");
    EXPECT_EQ(said([] { throw InputError("a.toml:1: none"); }), "a.toml:1: none");
}

}  // namespace read_file_test
}  // namespace tw

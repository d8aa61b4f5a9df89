// The main program of every test program. It gives a test the same surroundings on every machine, whether ctest or a
// user starts it:
//
//   TWINWAKE_ISA    The variant of the pair loops: avx2 where the processor has it, else baseline; never one that was
//                   found the fastest. A variant that the caller names is kept.
//   TMPDIR          A new folder in the caller's, so that tests side by side, other checkouts and other users never
//                   meet in one. It is removed at the end unless a test failed.
//   XDG_CACHE_HOME  In that folder: what runs teach stays in the test.
//   VTK_SMP_BACKEND_IN_USE
//                   Sequential: untrusted files are read in a child process, and the address sanitizer's allocator
//                   (GCC 12) may stay locked for ever in the child of a process that has other threads.
//   LP_NUM_THREADS, MESA_SHADER_CACHE_DISABLE
//                   0 and true: Mesa's software driver draws in the caller's thread and writes no cache of shaders
//                   behind its back, whose threads would still be at work when the program ends.
//
// Programs that a test starts inherit them all.
#include <gtest/gtest.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

namespace {

namespace fs = std::filesystem;

const char* pinned_variant() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("x86-64-v3")) return "avx2";
#endif
    return "baseline";
}

fs::path new_folder() {
    std::string name = (fs::temp_directory_path() / "twinwake_tests_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw fs::filesystem_error("mkdtemp", name, {errno, std::generic_category()});
    return fs::canonical(name);
}

}  // namespace

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    setenv("TWINWAKE_ISA", pinned_variant(), 0);
    setenv("VTK_SMP_BACKEND_IN_USE", "Sequential", 1);
    setenv("LP_NUM_THREADS", "0", 1);
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
    const fs::path folder = new_folder();
    setenv("TMPDIR", folder.c_str(), 1);
    setenv("XDG_CACHE_HOME", (folder / "cache").c_str(), 1);
    const int status = RUN_ALL_TESTS();
    if (status == 0) {
        std::error_code ignored;
        fs::remove_all(folder, ignored);
    } else {
        std::printf("files of the tests that failed: %s\n", folder.c_str());
    }
    return status;
}

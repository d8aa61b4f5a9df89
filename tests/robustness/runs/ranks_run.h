#pragma once
// Runs of the program by several processes, compared byte for byte with those of one.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "program.h"
#include "sph_solver/parallel/comm.h"

namespace tw::test {
namespace ranks_test {

namespace fs = std::filesystem;

class Ranks : public testing::Test {
protected:
    void SetUp() override {
        if (!Comm::built_with_mpi()) GTEST_SKIP() << "built without MPI";
        setenv("LSAN_OPTIONS", "exitcode=0", 1);  // MPI frees not all it has
    }
};

std::vector<std::string> command(const fs::path& scene, const fs::path& out, int ranks);
/// Gives the run's folder.
fs::path run(const fs::path& scene, const fs::path& folder, int ranks, const std::vector<std::string>& more = {});
void expect_same(const fs::path& one, const fs::path& other, const std::string& what);
void same_for_any_ranks(const fs::path& scene, const fs::path& folder, const std::vector<int>& numbers,
                        const std::vector<std::string>& more = {});
/// Of a scene to 0.3 s: to 0.1 s with 4 ranks, to 0.2 s with one, to its end with 3. `more`: words of each command.
void goes_on_with_another_number_of_ranks(const std::string& text, const ScratchFolder& folder,
                                          const std::vector<std::string>& more = {});

extern const char* const column_on_an_obstacle;
/// Water that runs into the zone of finer particles about an obstacle.
std::string column_and_fine_particles();
/// `text` with what stands in it once replaced by something else.
std::string with(std::string text, const std::string& what, const std::string& by);
std::string text_of(const char* file);
/// Of the particles of the k-th size, the last entry of a column in the record.
double last(const fs::path& run, int k, const char* column);
/// Particles in all.
double taken_by_gate(const fs::path& run);

}  // namespace ranks_test
}  // namespace tw::test

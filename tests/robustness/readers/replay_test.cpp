// Every input of the corpus, sound or such as once crashed or hung a reader, is read or refused in words.
#include <gtest/gtest.h>

#include <algorithm>

#include "base/atomic_file.h"
#include "test_paths.h"
#include "tests/robustness/readers/all_readers.h"

namespace tw {
namespace replay_test {
namespace fs = std::filesystem;

const fs::path corpus = fs::path(TWINWAKE_SOURCE) / "tests/robustness/readers/corpus";

class Replay : public testing::TestWithParam<readers::Reader> {
protected:
    const fs::path folder = fs::temp_directory_path() / ("reader_" + GetParam().name);
};

TEST_P(Replay, EveryInputOfTheCorpusEndsInWords) {
    int read = 0;
    for (const auto& entry : fs::directory_iterator(corpus / GetParam().name)) {
        const std::string bytes = read_text(entry.path());
        const std::string words = readers::feed(GetParam(), {bytes, folder});
        read += words.empty();
        // seeds are sound: a reader that refuses everything would pass otherwise
        const std::string name = entry.path().filename().string();
        EXPECT_TRUE(!name.starts_with("seed") || words.empty()) << name << ": " << words;
        EXPECT_TRUE(!name.starts_with("refused") || !words.empty()) << name << " was read";
    }
    EXPECT_GT(read, 0) << "no seed was read";
}

/// Cut off, and with a byte changed here and there.
TEST_P(Replay, DamagedSeedsEndInWords) {
    for (const auto& entry : fs::directory_iterator(corpus / GetParam().name)) {
        if (!entry.path().filename().string().starts_with("seed")) continue;
        const std::string bytes = read_text(entry.path());
        const std::size_t step = std::max<std::size_t>(1, bytes.size() / 5);
        for (std::size_t k = 0; k < bytes.size(); k += step) {
            readers::feed(GetParam(), {std::string_view(bytes).substr(0, k), folder});
            std::string changed = bytes;
            changed[k] = static_cast<char>(~changed[k]);
            readers::feed(GetParam(), {changed, folder});
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Readers, Replay, testing::ValuesIn(readers::all_readers()),
                         [](const auto& test) { return test.param.name; });

}  // namespace replay_test
}  // namespace tw

// Feeds a reader with changed seeds where the compiler has no libFuzzer:
//
//   fuzz_readers --reader=NAME [--seconds=N] [--inputs=N] [--seed=N] FOLDER     seeds are the files of the folder
//   fuzz_readers --reader=NAME FILE                                             this input once
//
// The inputs of a seed are one row, the same on every machine; a fast one gets further along it. The driver writes each
// to a file before it is read, so that an input that crashes the process, runs for ten seconds of its own or takes too
// much memory is there afterwards; the first line names it.
#include <sanitizer/common_interface_defs.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "base/atomic_file.h"
#include "tests/fuzz/readers/mutate.h"
#include "tests/fuzz/readers/target.h"

namespace tw {
namespace {

namespace fs = std::filesystem;

constexpr long most_memory = 2048;    // of the process [MiB], sanitizers included
constexpr int most_own_seconds = 10;  // for one input, of the processor
constexpr int most_seconds = 120;     // by the clock: a child of VTK's readers may take sixty

std::string last_words;  ///< when an input does harm

void say(const char* what) {
    for (const char* words : {"\n", what, last_words.c_str()})
        if (write(STDERR_FILENO, words, std::strlen(words)) < 0) return;
}
void on_signal(int signal) {
    say(signal == SIGPROF || signal == SIGALRM ? "hangs" : "ends the process by a signal");
    _exit(1);
}
void limit_time(int own, int all) {
    const itimerval timer{{}, {own, 0}};
    setitimer(ITIMER_PROF, &timer, nullptr);
    alarm(static_cast<unsigned>(all));
}

void feed_one(const std::string& bytes) {
    limit_time(most_own_seconds, most_seconds);
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    limit_time(0, 0);
    rusage use{};
    getrusage(RUSAGE_SELF, &use);
    if (use.ru_maxrss / 1024 > most_memory) {
        say("takes too much memory");
        _exit(1);
    }
}

std::vector<std::string> seeds_in(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.is_regular_file()) files.push_back(entry.path());
    std::ranges::sort(files);
    std::vector<std::string> seeds;
    for (const fs::path& file : files) seeds.push_back(read_text(file));
    return seeds;
}

/// Where a walk along the row of inputs ends, whichever comes first.
struct Reach {
    double seconds = 10, inputs = 1e15;
};

void fuzz(const fs::path& folder, const std::string& reader, std::uint64_t seed, const Reach& reach) {
    const std::vector<std::string> seeds = seeds_in(folder);
    if (seeds.empty()) {
        std::fprintf(stderr, "%s holds no seed\n", folder.c_str());
        std::exit(2);
    }
    const fs::path kept = fs::current_path() / ("crash_" + reader + "_" + std::to_string(seed));
    std::printf("%s: --seed=%llu; the input at hand is in %s\n", reader.c_str(), static_cast<unsigned long long>(seed),
                kept.c_str());
    std::fflush(stdout);
    std::mt19937_64 random(seed);
    std::size_t count = 0;
    const auto begin = std::chrono::steady_clock::now();
    const auto passed = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(); };
    for (; passed() < reach.seconds && static_cast<double>(count) < reach.inputs; ++count) {
        const std::string bytes = count < seeds.size() ? seeds[count] : readers::mutated(seeds, random);
        std::ofstream(kept, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        last_words = " at input " + std::to_string(count) + " of --seed=" + std::to_string(seed) + ", kept in " +
                     kept.string() + "\n";
        feed_one(bytes);
    }
    fs::remove(kept);
    std::printf("%zu inputs in %.1f s, none did harm\n", count, passed());
}

double number(std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc() && end == text.data() + text.size() && value >= 0 && value < 1e15) return value;
    std::fprintf(stderr, "expected a number, found '%.*s'\n", static_cast<int>(text.size()), text.data());
    std::exit(2);
}

}  // namespace
}  // namespace tw

/// A larger request is an error, not an attempt.
extern "C" const char* __asan_default_options() { return "max_allocation_size_mb=1024:handle_abort=1"; }

int main(int count, char** words) {
    LLVMFuzzerInitialize(&count, &words);
    tw::Reach reach;
    double seed = 1;
    std::string reader;
    tw::fs::path inputs;
    for (int k = 1; k < count; ++k) {
        const std::string_view word = words[k], value = word.substr(std::min(word.find('=') + 1, word.size()));
        if (word.starts_with("--reader="))
            reader = value;
        else if (word.starts_with("--seconds="))
            reach.seconds = tw::number(value);
        else if (word.starts_with("--inputs="))
            reach.inputs = tw::number(value);
        else if (word.starts_with("--seed="))
            seed = tw::number(value);
        else
            inputs = word;
    }
    __sanitizer_set_death_callback([] { tw::say("is an error of memory or an exception that is none of ours"); });
    for (const int signal : {SIGPROF, SIGALRM}) std::signal(signal, tw::on_signal);
    if (tw::fs::is_directory(inputs)) {
        tw::fuzz(inputs, reader, static_cast<std::uint64_t>(seed), reach);
    } else {
        tw::last_words = ": " + inputs.string() + "\n";
        tw::feed_one(tw::read_text(inputs));
    }
    return 0;
}

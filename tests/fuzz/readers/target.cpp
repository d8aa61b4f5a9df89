// One of the program's readers as a target of libFuzzer.
#include "tests/fuzz/readers/target.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "tests/robustness/readers/all_readers.h"

namespace tw {
namespace {

namespace fs = std::filesystem;

const readers::Reader* the_reader = nullptr;

const readers::Reader* reader_named(std::string_view name) {
    const auto found = std::ranges::find(readers::all_readers(), name, &readers::Reader::name);
    return found == readers::all_readers().end() ? nullptr : &*found;
}

/// Of this process, in $TMPDIR; gone when it ends by itself.
class FolderOfInputs {
public:
    FolderOfInputs() : path(fs::temp_directory_path() / ("twinwake_fuzz_" + std::to_string(getpid()))) {
        fs::create_directory(path);
    }
    ~FolderOfInputs() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
    FolderOfInputs(const FolderOfInputs&) = delete;
    FolderOfInputs& operator=(const FolderOfInputs&) = delete;
    const fs::path path;
};
const fs::path& folder_of_inputs() {
    static const FolderOfInputs folder;
    return folder.path;
}

}  // namespace
}  // namespace tw

int LLVMFuzzerInitialize(int* count, char*** words) {
    constexpr std::string_view option = "--reader=";
    for (int k = 1; k < *count; ++k) {
        const std::string_view word = (*words)[k];
        if (word.starts_with(option)) tw::the_reader = tw::reader_named(word.substr(option.size()));
    }
    if (tw::the_reader == nullptr) {
        std::fputs("expected --reader=NAME, one of:", stderr);
        for (const tw::readers::Reader& reader : tw::readers::all_readers())
            std::fprintf(stderr, " %s", reader.name.c_str());
        std::fputs("\n", stderr);
        std::exit(2);
    }
    tw::folder_of_inputs();
    return 0;
}

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    feed(*tw::the_reader, {{reinterpret_cast<const char*>(bytes), size}, tw::folder_of_inputs()});
    return 0;
}

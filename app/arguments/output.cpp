#include "app/arguments/output.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>

#include "base/atomic_file.h"
#include "compare/report/escape.h"

namespace tw::app {
namespace {

namespace fs = std::filesystem;

int first_error = 0;  ///< why standard output did not take something; 0: it took all

void print(const std::string& text) {
    errno = 0;
    const bool taken = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
    if (!taken && first_error == 0) first_error = errno == 0 ? EIO : errno;
}

}  // namespace

void say(const Common& common, const std::string& text) {
    if (!common.quiet && common.json != "-") print(for_terminal(text));
}

void complain(const std::string& line) { std::fputs((for_terminal(line) + "\n").c_str(), stderr); }

void write_json(const Common& common, const std::string& json) {
    if (common.json.empty()) return;
    if (common.json == "-") return print(json + "\n");
    try {
        write_file(common.json, json + "\n");
    } catch (const InputError& e) { throw InputError(std::string("--json ") + e.what()); }
}

void refuse_unwritable_json(const Common& common) {
    if (common.json.empty() || common.json == "-") return;
    const fs::path file = common.json, folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    std::error_code none;
    if (fs::is_directory(file, none)) throw InputError("--json " + file.string() + ": is a folder; expected a file");
    const bool there = fs::exists(file, none) && !fs::is_regular_file(file, none);  // a device or a pipe
    const fs::path& target = there ? file : folder;
    if (::access(target.c_str(), W_OK) != 0)
        throw InputError("--json " + file.string() + ": cannot be written: " + std::strerror(errno));
}

void write_file(const fs::path& file, const std::string& text) {
    std::error_code none;
    if (!fs::exists(file, none) || fs::is_regular_file(file, none))
        return leaving_files([&] { write_text_atomically(file, text); });
    std::ofstream out(file, std::ios::binary);  // renaming over a device would replace it
    errno = 0;
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
    out.close();
    if (!out) throw InputError(file.string() + ": cannot be written: " + std::strerror(errno == 0 ? EIO : errno));
}

void make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw InputError(folder.string() + ": the folder cannot be created: " + error.message());
}

bool everything_was_printed() {
    std::cout.flush();
    errno = 0;
    if (std::fflush(stdout) != 0 && first_error == 0) first_error = errno;
    if (first_error == 0 && (std::ferror(stdout) != 0 || !std::cout)) first_error = EIO;
    if (first_error != 0) std::fprintf(stderr, "standard output: cannot be written: %s\n", std::strerror(first_error));
    return first_error == 0;
}

}  // namespace tw::app

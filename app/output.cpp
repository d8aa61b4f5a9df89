#include "app/output.h"

#include <cstdio>

#include "base/atomic_file.h"

namespace tw::app {

void say(const Common& common, const std::string& text) {
    if (common.quiet || common.json == "-") return;
    std::fwrite(text.data(), 1, text.size(), stdout);
    std::fflush(stdout);
}

void write_json(const Common& common, const std::string& json) {
    if (common.json.empty()) return;
    if (common.json != "-") return write_text_atomically(common.json, json + "\n");
    std::fwrite(json.data(), 1, json.size(), stdout);
    std::fputc('\n', stdout);
}

}  // namespace tw::app

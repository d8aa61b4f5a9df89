#include "app/cluster/site.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/errors.h"
#include "base/read_file.h"
#include "text/section.h"
#include "text/units.h"

namespace tw::app {
namespace {

namespace fs = std::filesystem;

constexpr std::pair<const char*, std::string Site::*> words_of_slurm[] = {
    {"account", &Site::account}, {"partition", &Site::partition}, {"qos", &Site::qos}, {"gpus", &Site::gpus}};

constexpr const char* expected_word = "expected letters, digits and any of _ . , : = + @ / -";
bool is_word(const std::string& text) {
    return !text.empty() && std::ranges::all_of(text, [](unsigned char c) {
        return std::isalnum(c) || std::string_view("_.,:=+@/-").find(static_cast<char>(c)) != std::string_view::npos;
    });
}

/// Why a text is no time; empty: it is one, or there is none.
std::string no_time(const std::string& text) {
    try {
        if (text.empty() || quantity(text, "s") >= 600) return {};
        return "expected at least 10 min, of which a job has two to save its state";
    } catch (const UnitError& e) { return e.what(); }
}

fs::path usual_file() {
    const char *config = std::getenv("XDG_CONFIG_HOME"), *home = std::getenv("HOME");
    if (config && *config) return fs::path(config) / "twinwake/site.toml";
    return home ? fs::path(home) / ".config/twinwake/site.toml" : fs::path();
}

int whole(Section& section, const std::string& key) {
    const auto n = section.number(key, "-", {1, 100000});
    if (n && *n != std::floor(*n)) section.fail(key, "expected a whole number");
    return n ? static_cast<int>(*n) : 0;
}

Site read_site(const fs::path& file) {
    const TextValue document = parse_document(read_text_within(file, largest_document), file);
    Section section(file, "", &document);
    Site site;
    for (const auto& [key, value] : words_of_slurm) {
        site.*value = section.text(key, "");
        if (section.has(key) && !is_word(site.*value)) section.fail(key, expected_word);
    }
    site.time = section.text("time", "");
    if (const std::string why = no_time(site.time); !why.empty()) section.fail("time", why);
    site.modules = section.choices("modules", {}).value_or(std::vector<std::string>{});
    site.container = section.text("container", "");
    site.program = section.text("program", "");
    site.cores = whole(section, "cores"), site.limit = whole(section, "limit");
    section.finish();
    return site;
}

}  // namespace

Site completed(Site first, const fs::path& file) {
    for (const auto& [key, value] : words_of_slurm)
        if (!(first.*value).empty() && !is_word(first.*value))
            throw InputError(fmt::format("--{} {}: {}", key, first.*value, expected_word));
    if (const std::string why = no_time(first.time); !why.empty())
        throw InputError(fmt::format("--time {}: {}", first.time, why));
    const fs::path taken = file.empty() && fs::exists(usual_file()) ? usual_file() : file;
    const Site site = taken.empty() ? Site{} : read_site(taken);
    for (const auto& value :
         {&Site::account, &Site::partition, &Site::qos, &Site::gpus, &Site::time, &Site::container, &Site::program})
        if ((first.*value).empty()) first.*value = site.*value;
    if (first.modules.empty()) first.modules = site.modules;
    if (first.cores == 0) first.cores = site.cores > 0 ? site.cores : 32;
    if (first.limit == 0) first.limit = site.limit;
    return first;
}

}  // namespace tw::app

#include "base/own_json.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "base/in_words.h"

namespace tw {
namespace {

using Json = nlohmann::json;

constexpr std::uintmax_t most_bytes = 64'000'000;
constexpr int deepest = 10;

struct OutOfLimits : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Deep nesting is refused while it is read: what walks through a value later does so by recursion.
bool refuse_depth(int depth, Json::parse_event_t, Json&) {
    if (depth > deepest) throw OutOfLimits(fmt::format("it is nested deeper than {} times", deepest));
    return true;
}

}  // namespace

void read_own_json(const std::filesystem::path& file, const std::function<void(const Json&)>& take) {
    const auto refuse = [&](const std::string& why) {
        throw InputError(fmt::format("{}: is not as this version writes it: {}", file.string(), why));
    };
    std::error_code no_size;
    if (std::filesystem::file_size(file, no_size) > most_bytes && !no_size) refuse("it has more than 64 MB");
    try {
        take(Json::parse(read_text(file), refuse_depth));
    } catch (const Json::exception& e) { refuse(in_words(e)); } catch (const OutOfLimits& e) {
        refuse(e.what());
    }
}

double number_within(const Json& from, const char* key, double low, double high) {
    const double value = from.at(key).get<double>();
    if (!(value >= low && value <= high))
        throw OutOfLimits(fmt::format("{} = {:.6g}, expected {:.6g} to {:.6g}", key, value, low, high));
    return value;
}

int whole_within(const Json& from, const char* key, int low, int high) {
    const double value = number_within(from, key, low, high);
    if (value != std::floor(value)) throw OutOfLimits(fmt::format("{} = {:.6g}, expected a whole number", key, value));
    return static_cast<int>(value);
}

}  // namespace tw

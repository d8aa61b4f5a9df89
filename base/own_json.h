#pragma once
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>

namespace tw {

/// Gives `take` the content of a file that the program wrote for itself and reads again: a study, what its runs tell, jobs,
/// sizes, paces. Anybody may have changed it since. Throws InputError naming the file: it cannot be read, has more than
/// 64 MB, is no JSON, is nested deeper than eight times, or `take` finds a key missing, of another kind, or out of its
/// limits.
void read_own_json(const std::filesystem::path& file, const std::function<void(const nlohmann::json&)>& take);

/// What stands under a key, within limits. For use in `take`.
double number_within(const nlohmann::json& from, const char* key, double low, double high);
int whole_within(const nlohmann::json& from, const char* key, int low, int high);

}  // namespace tw

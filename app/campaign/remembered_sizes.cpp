#include <fmt/format.h>

#include "app/arguments/output.h"
#include "app/campaign/budget.h"
#include "base/atomic_file.h"
#include "base/errors.h"
#include "base/own_json.h"
#include "text/plain_number.h"

namespace tw::app {

namespace {
std::filesystem::path sizes_file(const std::filesystem::path& out) { return out / "sizes.json"; }
}  // namespace

std::optional<PaidSizes> remembered_sizes(const std::filesystem::path& out, double budget) {
    const std::filesystem::path file = sizes_file(out);
    if (!std::filesystem::exists(file)) return {};
    constexpr double tiny = 1e-300, huge = 1e300;
    PaidSizes sizes;
    read_own_json(file, [&](const nlohmann::json& json) {
        if (const double of = number_within(json, "budget", 0, huge); of != budget)
            throw InputError(
                fmt::format("{}: the sizes there were chosen for --budget {}; continue with that budget, run anew with "
                            "--overwrite, or "
                            "choose another folder with --out",
                            file.string(), plain_number(of) + " s"));
        sizes = {number_within(json, "scale", 1e-3, 1e3), number_within(json, "near_hull", tiny, huge),
                 number_within(json, "seconds", 0, huge)};
    });
    return sizes;
}

void remember(const PaidSizes& sizes, double budget, const std::filesystem::path& out) {
    const nlohmann::ordered_json json = {
        {"budget", budget}, {"scale", sizes.scale}, {"near_hull", sizes.near_hull}, {"seconds", sizes.seconds}};
    leaving_files([&] { write_text_atomically(sizes_file(out), json.dump(1) + "\n"); });
}

}  // namespace tw::app

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <numbers>

#include "base/errors.h"
#include "base/trimmed.h"
#include "structure/laminate.h"

namespace tw::structure {
namespace {

[[noreturn]] void refuse(std::string_view text, std::string_view layer, const std::string& why) {
    throw InputError(fmt::format("layup \"{}\": layer \"{}\": {}", text, layer, why));
}
}  // namespace

std::vector<Ply> read_layup(std::string_view text, const std::vector<std::pair<std::string, Ply>>& materials) {
    const std::string_view all = trimmed(text);
    const auto close = all.find(']');
    if (all.empty() || all.front() != '[' || close == all.npos)
        throw InputError(fmt::format("layup \"{}\": expected layers in brackets, as in \"[45 C1/0 C2]s\"", text));
    const std::string_view suffix = trimmed(all.substr(close + 1));
    if (!suffix.empty() && suffix != "s")
        throw InputError(fmt::format("layup \"{}\": \"{}\" after the bracket; expected s or nothing", text, suffix));

    std::vector<Ply> plies;
    for (std::string_view rest = all.substr(1, close - 1); !rest.empty();) {
        const auto slash = rest.find('/');
        const std::string_view layer = trimmed(rest.substr(0, slash));
        rest = slash == rest.npos ? std::string_view{} : rest.substr(slash + 1);

        double degrees = 0;
        const auto [end, error] = std::from_chars(layer.data(), layer.data() + layer.size(), degrees);
        if (error != std::errc{}) refuse(text, layer, "expected an angle in degrees first");
        std::string_view name = trimmed(layer.substr(static_cast<std::size_t>(end - layer.data())));
        int count = 1;
        if (const auto star = name.find('*'); star != name.npos) {
            const auto [stop, bad] = std::from_chars(name.data(), name.data() + star, count);
            if (bad != std::errc{} || stop != name.data() + star || count < 1)
                refuse(text, layer, "expected a count of layers before the *");
            name = trimmed(name.substr(star + 1));
        }
        const auto found = std::find_if(materials.begin(), materials.end(), [&](auto& m) { return m.first == name; });
        if (found == materials.end()) refuse(text, layer, fmt::format("no material is named \"{}\"", name));
        Ply ply = found->second;
        ply.angle = degrees * std::numbers::pi / 180;
        plies.insert(plies.end(), static_cast<std::size_t>(count), ply);
    }
    if (suffix == "s") {
        const std::vector<Ply> half = plies;
        plies.insert(plies.end(), half.rbegin(), half.rend());
    }
    return plies;
}

}  // namespace tw::structure

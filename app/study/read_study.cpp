#include "app/study/study.h"
#include "app/study/study_keys.h"
#include "base/errors.h"
#include "base/own_json.h"
#include "methods/methods.h"

namespace tw::app {
namespace {

namespace fs = std::filesystem;

constexpr double any_number = 1e300;  ///< what a number of a scene may be, its reader says

SceneOverrides overrides_of(const nlohmann::json& json) {
    SceneOverrides o;
    if (json.contains("hull")) o.hull_file = json["hull"].get<std::string>();
    for (const auto& [key, value] : given_in_study)
        if (json.contains(key)) o.*value = number_within(json, key, -any_number, any_number);
    for (const auto& [key, factor] : factors_in_study)
        if (json.contains(key)) o.*factor = number_within(json, key, 1e-6, 1e6);
    o.device = json.value("device", "");
    o.interface = json.value("interface", "");
    if (!o.interface.empty() && o.interface != "isoadvector")
        throw InputError("interface: \"" + o.interface + "\"; expected \"isoadvector\"");
    o.wave_twin = json.value("wave_twin", false);
    if (json.contains("effects")) o.effects = json["effects"].get<std::map<std::string, bool>>();
    return o;
}

Member member_of(const nlohmann::json& json) {
    const nlohmann::json& predicted = json.at("predicted");
    const auto amount = [&](const char* key) { return number_within(predicted, key, 0, any_number); };
    // One by one: GCC 12 destroys twice what a list in braces within another holds when a later entry throws.
    Member m;
    m.name = json.at("name");
    m.method = method_named(json.at("method")).name;
    m.folder = json.at("folder").get<std::string>();
    m.request.file = json.at("scene").get<std::string>();
    m.request.overrides = overrides_of(json.at("changes"));
    if (json.contains("numbers"))
        for (const auto& [name, value] : json["numbers"].items())
            m.request.numbers[name] = number_within(json["numbers"], name.c_str(), -any_number, any_number);
    m.request.method = json.at("methods");
    m.request.threads = whole_within(json, "threads", 0, 100'000);
    m.request.ranks = json.contains("ranks") ? whole_within(json, "ranks", 1, 65'535) : 1;
    m.request.snapshots = json.at("snapshots");
    m.seconds = amount("seconds");
    m.bytes = amount("bytes");
    m.elements = amount("elements");
    return m;
}

}  // namespace

fs::path study_folder(const fs::path& out) { return out / "study"; }
fs::path state_file(const fs::path& out, std::size_t number) {
    return study_folder(out) / "members" / (std::to_string(number) + ".json");
}
fs::path log_file(const fs::path& out, std::size_t number) {
    return study_folder(out) / "members" / (std::to_string(number) + ".log");
}

Study read_study(const fs::path& out) {
    const fs::path file = study_folder(out) / "study.json";
    if (!fs::exists(file))
        throw InputError(out.string() + ": no study has been submitted or run with --jobs there; expected " +
                         file.string());
    Study study;
    read_own_json(file, [&](const nlohmann::json& json) {
        study.out = json.at("out").get<std::string>();
        study.words = json.at("report");
        study.overwrite = json.at("overwrite");
        study.take_finished = json.at("take_finished");
        study.where = json.at("where").get<std::string>();
        for (const nlohmann::json& m : json.at("members")) study.members.push_back(member_of(m));
    });
    return study;
}

}  // namespace tw::app

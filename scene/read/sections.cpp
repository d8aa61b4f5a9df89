#include <fmt/format.h>

#include "methods/methods.h"
#include "scene/read/read.h"

namespace tw {

Sections split_sections(const std::filesystem::path& file, const TextValue& document) {
    SceneSection root(file, "", &document);
    const auto one = [&](const std::string& name) { return SceneSection(root.section(name)); };
    const auto many = [&](const std::string& name) {
        std::vector<SceneSection> all;
        for (Section& section : root.sections(name)) all.emplace_back(std::move(section));
        return all;
    };
    Sections s{root,
               one("hull"),
               one("water"),
               one("motion"),
               one("wave"),
               one("resolution"),
               one("domain"),
               one("run"),
               one("sampling"),
               one("tank"),
               one("effects"),
               {},
               many("obstacle"),
               many("body"),
               many("probe"),
               many("water_block"),
               many("refine"),
               many("ply"),
               many("gauge"),
               many("volume"),
               many("measured")};
    for (const std::string& method : method_names()) s.numerics.emplace(method, one(method));
    s.root = root;
    s.root.know("title");
    s.root.know("uncertain");
    s.root.finish();
    return s;
}

std::string Scene::place_of(const std::string& key) const {
    const auto found = places.find(key);
    if (found != places.end()) return found->second;
    const std::size_t dot = key.find('.');
    return fmt::format("{}: [{}] {}", file.string(), key.substr(0, dot), key.substr(dot + 1));
}

}  // namespace tw

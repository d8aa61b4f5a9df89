#include "suite/basis.h"

#include <fmt/format.h>

#include "base/read_file.h"
#include "base/sha256.h"
#include "methods/methods.h"
#include "scene/hash.h"
#include "scene/keys/keys.h"

namespace tw {
namespace {

namespace fs = std::filesystem;

/// Tells two texts apart.
std::string digest_of(const std::string& text) { return sha256_hex(text).substr(0, 16); }

TextValue document_in(const fs::path& file) { return parse_document(read_text_within(file, largest_document), file); }

/// The table of a section such as "hull.free"; null: the file has none.
const TextValue* table_in(const TextValue& document, const std::string& section) {
    const TextValue* table = &document;
    for (std::size_t at = 0; table && at <= section.size();) {
        const std::size_t end = std::min(section.find('.', at), section.size());
        table = table->find(section.substr(at, end - at));
        at = end + 1;
    }
    return table;
}

/// What the file says of the method's numerics and of how a run begins.
std::string numerics_as_written(const fs::path& file, const std::string& method) {
    const TextValue document = document_in(file);
    std::string text;
    for (const SceneKey& key : scene_keys()) {
        if (key.hashed != SceneKey::Hashed::run || (find_method(key.section) && key.section != method)) continue;
        const TextValue* section = table_in(document, key.section);
        if (!section) continue;
        const bool repeated = section->kind == TextValue::Kind::list;
        for (const TextValue& table : repeated ? section->list : std::vector{*section})
            if (const TextValue* value = table.find(key.name))
                text += fmt::format("{}.{} {}\n", key.section, key.name, value->shown());
    }
    return text;
}

std::string scene_text(const SuiteScene& of, const std::string& method) {
    const Scene scene = read_scene(of.file, of.changes);
    std::string text = fmt::format("{}\nduration {}\n", scene_hash(scene), scene.run.duration);
    for (const UncertainNumber& n : uncertain_numbers(of.file, of.changes, of.uncertain ? &*of.uncertain : nullptr))
        text += fmt::format("uncertain {} {}\n", n.name, n.half_width);
    return text + numerics_as_written(of.file, method);
}

std::string definition_text(const SuiteQuantity& q, const SuiteScene& scene) {
    std::string text = fmt::format("{}\nsizes {} {}\n", q.judged.unit, scene.levels, scene.ratio);
    if (const auto& r = q.reading)
        text += fmt::format("reading {} {} {} {} {} {} {}\n", r->table, r->column, static_cast<int>(r->kind), r->from,
                            r->to, r->at, r->threshold);
    return text;
}

/// Every file that the mapping names, in its order; the scene is one of them only by its name, as its hash counts.
void add_files(const TextValue& value, const fs::path& folder, std::string& text) {
    if (value.kind == TextValue::Kind::text && fs::is_regular_file(folder / value.text))
        text += sha256_hex(read_text_within(folder / value.text, std::size_t{1} << 32)) + "\n";
    for (const auto& [key, member] : value.members)
        if (key != "scene") add_files(member, folder, text);
    for (const TextValue& item : value.list) add_files(item, folder, text);
}

std::string truth_text(const fs::path& mapping) {
    std::string text = read_text_within(mapping, largest_document);
    add_files(parse_document(text, mapping), mapping.parent_path(), text);
    return text;
}

}  // namespace

std::string scene_digest(const SuiteScene& scene, const std::string& method) {
    return digest_of(scene_text(scene, method));
}

std::string definition_digest(const SuiteQuantity& quantity, const SuiteScene& scene) {
    return digest_of(definition_text(quantity, scene));
}

std::string truth_digest(const SuiteQuantity& quantity) {
    return quantity.measured.empty() ? "" : digest_of(truth_text(quantity.measured));
}

}  // namespace tw

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/errors.h"
#include "base/read_file.h"
#include "methods/methods.h"
#include "suite/read_truth.h"
#include "suite/suite.h"
#include "text/section.h"
#include "text/units.h"

namespace tw {
namespace {

namespace fs = std::filesystem;

// All keys of the tables in which something is required: a misspelt one is named before what is missing without it.
const std::set<std::string> keys_of_scene{"methods", "levels", "ratio", "changes", "uncertain"},
    keys_of_case{"name", "title", "family", "tier", "why", "shows", "shows_not", "scene", "quantity"},
    keys_of_reading{"table", "column", "kind", "from", "to", "at", "threshold"},
    keys_of_quantity{"name",   "label",  "unit",        "scene",    "reading", "known_miss", "truth", "formula",
                     "csv",    "record", "parameters",  "column",   "row",     "along",      "at",    "factor",
                     "offset", "source", "uncertainty", "standing", "scale",   "goal"};

std::set<std::string> both(std::set<std::string> some, const std::set<std::string>& others) {
    some.insert(others.begin(), others.end());
    return some;
}

/// What is changed of a scene: the same as on the command line of `run`.
void read_changes(Section s, SuiteScene& scene) {
    SceneOverrides& o = scene.changes;
    o.speed = s.number("speed", "m/s", not_negative);
    o.trim = s.number("trim", "rad");
    o.spacing = s.number("spacing", "m", positive);
    o.near_hull = s.number("near_hull", "m", positive);
    o.duration = s.number("duration", "s", positive);
    o.scale_resolution = s.number("scale", "-", positive);
    if (const auto hull = s.text("hull")) o.hull_file = s.file().parent_path() / *hull;
    for (const auto& [key, on] : {std::pair{"effects_on", true}, {"effects_off", false}})
        for (const std::string& name : s.choices(key, {}).value_or(std::vector<std::string>{})) o.effects[name] = on;
    s.finish();
}

/// `s`: of a case with one scene the case itself, else one of its [[scene]].
SuiteScene read_suite_scene(Section& s, const TextValue& raw, const std::string& file_key) {
    SuiteScene scene;
    const std::optional<std::string> file = s.text(file_key);
    if (!file) s.fail(file_key, "missing; expected a scene file, relative to this one");
    scene.file = (s.file().parent_path() / *file).lexically_normal();
    scene.place = s.where(file_key);
    if (const auto methods = s.choices("methods", method_names())) scene.methods = *methods;
    scene.levels = static_cast<int>(s.number("levels", scene.levels, "-", {1, 8}));
    scene.ratio = s.number("ratio", scene.ratio, "-", {1.05, 4});
    read_changes(s.section("changes"), scene);
    if (s.section("uncertain").present()) scene.uncertain = UncertainTable{s.file(), *raw.find("uncertain")};
    return scene;
}

Reading read_reading(Section s) {
    refuse_others_than(keys_of_reading, s);
    Reading r;
    const auto needed = [&](const char* key, const char* what) {
        const std::optional<std::string> text = s.text(key);
        if (!text) s.fail(key, std::string("missing; expected ") + what);
        return *text;
    };
    r.table = needed("table", "a table of the record: height, pressure, forces, body_NAME, ...");
    r.column = needed("column", "one of the table's columns: a probe's name, z, fx, ...");
    const std::string kind = s.choice("kind", "mean", reading_kinds());
    r.kind = static_cast<Reading::Kind>(std::ranges::find(reading_kinds(), kind) - reading_kinds().begin());
    r.from = s.number("from", r.from, "s"), r.to = s.number("to", r.to, "s");
    if (!(r.from < r.to)) s.fail("to", "expected a later time than from");
    r.at = s.number("at", r.at, "s");
    if ((kind == "at") != s.has("at")) s.fail("at", "a time for kind = \"at\", and for no other kind");
    r.threshold = s.number("threshold", r.threshold, "-");
    if ((kind == "crossing") != s.has("threshold"))
        s.fail("threshold", "a value of the column, in SI, for kind = \"crossing\", and for no other kind");
    s.finish();
    return r;
}

SuiteQuantity read_quantity(Section s, const TextValue& raw, const SuiteCase& of) {
    refuse_others_than(keys_of_quantity, s);
    SuiteQuantity q;
    const std::optional<std::string> name = s.text("name");
    if (!name || name->empty())
        s.fail("name",
               "missing; expected a quantity of report.json, such as lift or pressure_mean:P1, or any name beside "
               "a [quantity.reading]");
    q.judged.name = *name;
    q.place = s.where("name");
    q.judged.label = s.text("label", "");
    q.judged.unit = s.text("unit", "-");
    try {
        if (parse_unit(q.judged.unit).factor != 1)
            s.fail("unit", "expected the SI unit of the quantity, as in report.json");
    } catch (const UnitError& e) { s.fail("unit", e.what()); }
    if (const auto scene = s.text("scene")) {
        const auto found = std::ranges::find(of.scenes, *scene, &SuiteScene::name);
        if (found == of.scenes.end()) s.fail("scene", "the case has no [[scene]] of this name");
        q.scene = static_cast<std::size_t>(found - of.scenes.begin());
    }
    if (s.has("reading")) q.reading = read_reading(s.section("reading"));
    read_truth(s, raw, q);
    if (q.reading && !q.measured.empty() && q.judged.label.empty()) q.judged.label = *name;
    Section known = s.section("known_miss");
    for (const std::string& method : method_names())
        if (const auto why = known.text(method)) q.judged.known_miss[method] = *why;
    known.finish();
    s.finish();
    return q;
}

SuiteCase read_case(Section s, const TextValue& raw, const std::string& name) {
    const TextValue* scene = raw.find("scene");
    const bool several = scene && scene->kind == TextValue::Kind::list;
    refuse_others_than(several ? keys_of_case : both(keys_of_case, keys_of_scene), s);
    SuiteCase c;
    c.name = s.identifier("name", name);
    c.title = s.text("title", c.name);
    c.family = s.identifier("family", "other");
    c.tier = s.choice("tier", suite_tiers().front(), suite_tiers());
    c.why = s.text("why", "");
    if (c.why.empty()) s.fail("why", "missing; expected a sentence why the case matters");
    c.shows = s.text("shows", ""), c.shows_not = s.text("shows_not", "");
    if (several) {
        const std::vector<TextValue>& raw_scenes = scene->list;
        std::vector<Section> scenes = s.sections("scene");
        for (std::size_t k = 0; k < scenes.size(); ++k) {
            Section& one = scenes[k];
            refuse_others_than(both({"name", "file"}, keys_of_scene), one);
            SuiteScene read = read_suite_scene(one, raw_scenes[k], "file");
            read.name = one.identifier("name", "");
            one.finish();
            if (std::ranges::find(c.scenes, read.name, &SuiteScene::name) != c.scenes.end())
                one.fail("name", "two scenes of the case have this name");
            c.scenes.push_back(std::move(read));
        }
    } else {
        c.scenes.push_back(read_suite_scene(s, raw, "scene"));
    }
    std::vector<Section> quantities = s.sections("quantity");
    if (quantities.empty()) s.fail("quantity", "missing; expected one [[quantity]] or more, with a truth each");
    const std::vector<TextValue>& raws = raw.find("quantity")->list;
    for (std::size_t k = 0; k < quantities.size(); ++k)
        c.quantities.push_back(read_quantity(quantities[k], raws[k], c));
    s.finish();
    return c;
}

void add_case(Suite& suite, SuiteCase c, const std::string& where) {
    if (std::ranges::find(suite.cases, c.name, &SuiteCase::name) != suite.cases.end())
        throw InputError(fmt::format("{}: a second case is called \"{}\"; expected a name for each", where, c.name));
    suite.cases.push_back(std::move(c));
}

TextValue document_of(const fs::path& file) { return parse_document(read_text_within(file, largest_document), file); }

}  // namespace

const std::vector<std::string>& suite_tiers() {
    static const std::vector<std::string> tiers{"minutes", "hour", "night", "gpu"};
    return tiers;
}

Suite read_suite(const fs::path& folder) {
    const fs::path file = folder / "suite.toml";
    if (!fs::is_regular_file(file))
        throw InputError(folder.string() +
                         ": no suite: it has no suite.toml; expected a folder with suite.toml (a "
                         "title, cases) and, for more cases, cases/*.toml");
    Suite suite;
    suite.folder = folder;
    const TextValue document = document_of(file);
    Section s(file, "", &document);
    refuse_others_than({"title", "case"}, s);
    suite.title = s.text("title", folder.filename().string());
    std::vector<Section> inline_cases = s.sections("case");
    for (std::size_t k = 0; k < inline_cases.size(); ++k) {
        const std::string where = inline_cases[k].where("name");
        add_case(suite, read_case(inline_cases[k], document.find("case")->list[k], ""), where);
    }
    s.finish();
    std::vector<fs::path> files;
    if (fs::is_directory(folder / "cases"))
        for (const fs::directory_entry& entry : fs::directory_iterator(folder / "cases"))
            if (entry.path().extension() == ".toml") files.push_back(entry.path());
    std::ranges::sort(files);
    for (const fs::path& one : files) {
        const TextValue of_case = document_of(one);
        add_case(suite, read_case(Section(one, "", &of_case), of_case, one.stem().string()), one.string());
    }
    if (suite.cases.empty())
        throw InputError(file.string() + ": a suite without a case; expected [[case]] in it, or files in cases/");
    return suite;
}

}  // namespace tw

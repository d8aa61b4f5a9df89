#include "import/mapping.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "base/read_file.h"
#include "meshes/axis_turn.h"
#include "methods/methods.h"
#include "record/water_in_box.h"
#include "text/section.h"
#include "text/units.h"

namespace tw {
namespace {

/// The columns of the record that a table may give, with their SI units; pressure, height and volume name the scene's
/// probes and boxes.
struct KnownTable {
    std::string name;
    std::vector<std::pair<std::string, std::string>> columns;
    std::string probe_unit;
};
const std::vector<KnownTable>& known_tables() {
    static const std::vector<KnownTable> tables{
        {"forces",
         {{"fx", "N"},
          {"fy", "N"},
          {"fz", "N"},
          {"my", "N m"},
          {"fx_pressure", "N"},
          {"fz_pressure", "N"},
          {"fx_viscous", "N"},
          {"fz_viscous", "N"}},
         ""},
        {"height", {}, "m"},
        {"pressure", {}, "Pa"},
        {volume_table, {}, "m3"},
        {"samples", {{"wetted_length", "m"}, {"wetted_area", "m2"}}, ""},
    };
    return tables;
}

/// The name of a method stands in tables, file names and the report: plain characters only.
void check_name(const Section& root, const std::string& name) {
    const auto plain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == ' ' || c == '.' ||
               c == '_' || c == '-';
    };
    if (name.empty() || name.size() > 40 || !std::ranges::all_of(name, plain) || name.front() == ' ' ||
        name.back() == ' ' || name.front() == '.' || name.front() == '-')
        root.fail("name",
                  "expected 1 to 40 of: letters, digits, blank, '.', '_', '-'; it begins with a letter or digit");
    if (find_method(name))
        root.fail("name",
                  fmt::format("{} are twinwake's own runs; choose another name", fmt::join(method_names(), " and ")));
}

/// fz = "Lift", fz = 3 or fz = { column = "Lift" or 3, unit = "kN", scale = -1, offset = "0.2 N" }.
ColumnSource read_column(const Section& parent, const std::string& key, const TextValue& value, ColumnSource c) {
    c.place = parent.where(key);
    const auto take = [&](const Section& at, const std::string& where, const TextValue& column) {
        if (column.kind == TextValue::Kind::text && !column.text.empty()) {
            c.header = column.text;
            return;
        }
        if (column.kind != TextValue::Kind::number || column.number != std::floor(column.number) || column.number < 1 ||
            column.number > 100000)
            at.fail(where, "expected a column: its header text, or its number from 1, e.g. \"Lift\" or 3");
        c.number = static_cast<int>(column.number);
    };
    if (value.kind != TextValue::Kind::table) {
        take(parent, key, value);
        return c;
    }
    Section s(parent.file(), parent.name().empty() ? key : parent.name() + "." + key, &value);
    s.know("column");
    const TextValue* column = value.find("column");
    if (!column) s.fail("column", "missing; expected the header text of the column, or its number from 1");
    take(s, "column", *column);
    c.unit = s.text("unit", "");
    if (!c.unit.empty()) {
        try {
            if (parse_unit(c.unit).dimension != parse_unit(c.si_unit).dimension)
                s.fail("unit", "does not measure the right thing; expected a unit like " + units_like(c.si_unit));
        } catch (const UnitError& e) { s.fail("unit", e.what()); }
    }
    c.scale = s.number("scale", 1.0, "-");
    if (c.scale == 0) s.fail("scale", "expected a number that is not 0; -1 turns the sign");
    c.offset = s.number("offset", 0.0, c.si_unit);
    c.uncertainty = s.number("uncertainty", 0.0, c.si_unit, {0, 1e30});
    s.finish();
    return c;
}

void read_columns(Section& root, const TextValue& document, Mapping& m) {
    for (const KnownTable& table : known_tables()) {
        root.know(table.name);
        const TextValue* given = document.find(table.name);
        if (!given) continue;
        if (given->kind != TextValue::Kind::table) root.fail(table.name, "expected a section [" + table.name + "]");
        Section s(root.file(), table.name, given);
        for (const auto& [name, unit] : table.columns) s.know(name);
        for (const auto& [name, value] : given->members) {
            const auto known = std::ranges::find(table.columns, name, &std::pair<std::string, std::string>::first);
            const bool is_known = known != table.columns.end();
            if (!is_known && table.probe_unit.empty()) continue;  // finish() names it
            s.know(name);
            ColumnSource c;
            c.table = table.name;
            c.name = name;
            c.si_unit = is_known ? known->second : table.probe_unit;
            m.columns.push_back(read_column(s, name, value, c));
        }
        s.finish();
    }
    root.know("time");
    if (const TextValue* time = document.find("time")) {
        ColumnSource c;
        c.name = "time";
        c.si_unit = "s";
        m.time = read_column(root, "time", *time, c);
    }
}

std::optional<WaterSource> read_water_source(Section& root, const TextValue& document,
                                             const std::filesystem::path& folder) {
    root.know("water");
    const TextValue* given = document.find("water");
    if (!given) return {};
    if (given->kind != TextValue::Kind::table) root.fail("water", "expected a section [water]");
    Section s(root.file(), "water", given);
    const auto column = [&](const std::string& key, const std::string& si_unit) -> std::optional<ColumnSource> {
        s.know(key);
        ColumnSource c;
        c.table = "water", c.name = key, c.si_unit = si_unit;
        const TextValue* value = given->find(key);
        return value ? std::optional(read_column(s, key, *value, c)) : std::nullopt;
    };
    const auto required = [&](const std::string& key, const std::string& si_unit) {
        auto c = column(key, si_unit);
        if (!c) s.fail(key, fmt::format("missing; expected a column, e.g. {0} = \"{0} [{1}]\"", key, si_unit));
        return *c;
    };
    const auto file = s.text("source");
    if (!file || file->empty()) s.fail("source", "missing; expected e.g. source = \"water.csv\"");
    WaterSource water{folder / *file,     required("time", "s"),    required("x", "m"),  required("y", "m"),
                      required("z", "m"), required("volume", "m3"), column("cell", "m3")};
    s.finish();
    return water;
}

/// How a logger writes its table; what is left open is found in the text.
LoggerForm read_form(Section& root) {
    LoggerForm form;
    form.separator = root.choice("separator", form.separator, {"auto", "tab", "semicolon", "comma", "blank"});
    form.decimal = root.choice("decimal", form.decimal, {"auto", "point", "comma"});
    form.clock = root.choice("clock", form.clock, {"auto", "none", "h:m:s", "m:s"});
    if (root.has("units_row")) form.units_row = root.flag("units_row", false);
    root.know("units_row");
    if (const std::optional<double> line = root.number("header_line", "-", {0, 1e6})) {
        if (*line != std::floor(*line)) root.fail("header_line", "expected a whole number; 0: there is no such line");
        form.header_line = static_cast<int>(*line);
    }
    for (const char* key : {"separator", "decimal", "clock", "units_row", "header_line"})
        if (root.has(key)) form.place[key] = root.where(key);
    return form;
}

/// Loads turn, they are not mirrored.
Eigen::Matrix3d read_axes(Section& root) {
    const std::string axes = root.text("axes", "xyz");
    Eigen::Matrix3d turn;
    try {
        turn = axis_turn(axes);
    } catch (const InputError&) {
        root.fail("axes", "expected each of x, y and z once, with a sign, e.g. \"x-zy\" (case with y up) or \"-x-yz\"");
    }
    if (turn.determinant() < 0)
        root.fail("axes", "mirrors the case; turn one more sign, e.g. \"-x-yz\" for a bow towards +x");
    return turn;
}

}  // namespace

Mapping read_mapping(const std::filesystem::path& file) {
    const TextValue document = parse_document(read_text_within(file, largest_document), file);
    Section root(file, "", &document);
    const auto required = [&](const std::string& key, const std::string& example) {
        const auto text = root.text(key);
        if (!text || text->empty()) root.fail(key, "missing; expected e.g. " + key + " = \"" + example + "\"");
        return *text;
    };
    Mapping m;
    m.file = file;
    required("kind", "csv");
    m.kind = root.choice("kind", "", {"csv", "openfoam", "dualsphysics"});
    m.name = required("name", "towing tank");
    check_name(root, m.name);
    m.source = file.parent_path() / required("source", m.kind == "openfoam" ? "my_case" : "forces.csv");
    m.scene = file.parent_path() / required("scene", "scene.toml");
    m.half_model = root.flag("half_model", m.half_model);
    m.moment_point = root.vector("moment_point", "m");
    m.near_hull = root.number("near_hull", "m", positive);
    m.water = read_water_source(root, document, file.parent_path());
    if (m.kind == "openfoam") {
        m.function_object = root.text("function_object", m.function_object);
        m.axes = read_axes(root);
    } else {
        if (root.has("friction")) m.friction = root.flag("friction", false);
        root.know("friction");
        read_columns(root, document, m);
    }
    if (m.kind == "csv") m.form = read_form(root);
    root.finish();
    if (m.kind == "csv" && !m.time)
        root.fail("time", "missing; expected e.g. time = \"t\", or a section [time] with column and unit");
    if (m.kind == "csv" && m.columns.empty())
        root.fail(
            "forces",
            "no column is mapped; expected at least one in [forces], [height], [pressure], [volume] or [samples]");
    for (const auto& [key, value] : document.members) m.place[key] = root.where(key);
    return m;
}

}  // namespace tw

#include "app/spray_study.h"

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "import/csv_columns.h"
#include "record/run_record.h"
#include "spray/air/foam_air.h"
#include "text/section.h"

namespace tw::app {
namespace {

namespace fs = std::filesystem;
using namespace spray;

constexpr Range above_zero{1e-300, 1e300};
constexpr Range share{0, 1};

/// The sections of the file, each asked for once.
class Document {
public:
    explicit Document(const fs::path& file)
        : file_(file), tree_(parse_document(read_text(file), file)), root_(file, "", &tree_) {}
    Section& root() { return root_; }
    Section section(const std::string& name) {
        root_.know(name);
        const TextValue* table = tree_.find(name);
        if (table && table->kind != TextValue::Kind::table) root_.fail(name, "expected a section [" + name + "]");
        return {file_, name, table};
    }
    std::vector<Section> list(const std::string& name) {
        root_.know(name);
        std::vector<Section> sections;
        const TextValue* value = tree_.find(name);
        if (!value) return sections;
        if (value->kind != TextValue::Kind::list) root_.fail(name, "expected sections [[" + name + "]]");
        for (const TextValue& one : value->list) {
            if (one.kind != TextValue::Kind::table) root_.fail(name, "expected sections [[" + name + "]]");
            sections.emplace_back(file_, "[" + name + "]", &one);
        }
        return sections;
    }
    fs::path path(const std::string& text) const { return file_.parent_path() / text; }

private:
    fs::path file_;
    TextValue tree_;
    Section root_;
};

void read_source(Document& document, SprayStudy& study) {
    Section s = document.section("source");
    if (!s.present()) s.fail("sph", "missing; expected [source] with sph, taken, fvm or table");
    if (const auto run = s.text("sph")) study.source.sph = document.path(*run);
    if (const auto run = s.text("taken")) study.source.taken = document.path(*run);
    if (const auto run = s.text("fvm")) study.source.fvm = document.path(*run);
    if (const auto table = s.text("table")) study.source.droplets = read_droplets(document.path(*table));
    std::vector<const char*> given;
    for (const char* way : {"sph", "taken", "fvm", "table"})
        if (s.has(way)) given.push_back(way);
    if (given.size() != 1)
        s.fail(given.empty() ? "sph" : given.back(), "expected exactly one of sph, taken, fvm and table");
    study.source.range.from = s.number("from", study.source.range.from, "s");
    study.source.range.to = s.number("to", study.source.range.to, "s");
    if (s.has("mirror")) study.source.mirror = s.flag("mirror", false);
    s.know("mirror");
    study.source.least_share = s.number("least_share", study.source.least_share, "-", share);
    s.finish();

    const fs::path run = !study.source.sph.empty()     ? study.source.sph
                         : !study.source.taken.empty() ? study.source.taken
                                                       : study.source.fvm;
    if (run.empty() || !fs::exists(run / "record.h5")) return;
    const RunRecord record = read_record(run / "record.h5");
    if (const auto n = record.numbers.find("density"); n != record.numbers.end())
        study.extraction.liquid.density = n->second;
    if (const auto n = record.numbers.find("gravity"); n != record.numbers.end())
        study.extraction.gravity = {0, 0, -n->second};
}

void read_water(Document& document, SprayStudy& study) {
    Section s = document.section("water");
    Liquid& l = study.extraction.liquid;
    l.density = s.number("density", l.density, "kg/m3", above_zero);
    l.viscosity = s.number("viscosity", l.viscosity, "Pa s", above_zero);
    l.surface_tension = s.number("surface_tension", l.surface_tension, "N/m", above_zero);
    study.extraction.gravity.z() = -s.number("gravity", -study.extraction.gravity.z(), "m/s2");
    s.finish();
}

void read_extraction(Document& document, SprayStudy& study) {
    Section s = document.section("extraction");
    ExtractOptions& o = study.extraction;
    o.link = s.number("link", o.link, "-", above_zero);
    o.fewest = static_cast<std::size_t>(s.number("fewest", 1, "-", {1, 1e9}));
    o.largest_diameter = s.number("largest_diameter", o.largest_diameter, "m", above_zero);
    const auto point = s.vector("gate_point", "m"), normal = s.vector("gate_normal", "-");
    const auto surface = s.text("gate_surface");
    if (point.has_value() != normal.has_value())
        s.fail(point ? "gate_point" : "gate_normal", "a plane needs both gate_point and gate_normal");
    if (point && surface) s.fail("gate_surface", "expected a plane or a surface, not both");
    if (point) o.gate = Gate::plane(*point, *normal);
    if (surface) o.gate = Gate::surface(read_surface(document.path(*surface)));
    o.attached = s.flag("attached", o.attached);
    o.already_beyond = s.flag("already_beyond", o.already_beyond);
    if (o.already_beyond && !point && !surface) s.fail("already_beyond", "expected a gate: gate_point, gate_normal");
    const std::string size = s.choice("size", "component", {"component", "particle", "breakup"});
    o.size = size == "component"  ? DropletSize::component
             : size == "particle" ? DropletSize::element
                                  : DropletSize::breakup;
    o.breakup.critical_weber = s.number("critical_weber", o.breakup.critical_weber, "-", above_zero);
    o.breakup.spread = s.number("spread", o.breakup.spread, "-", {1, 10});
    o.breakup.smallest = s.number("smallest", o.breakup.smallest, "-", {0.01, 0.9});
    o.seed = static_cast<std::uint64_t>(s.number("seed", 1, "-", {0, 1e15}));
    s.finish();
}

void read_air(Document& document, SprayStudy& study) {
    Section s = document.section("air");
    AirState state;
    state.velocity = s.vector("velocity", "m/s").value_or(state.velocity);
    state.density = s.number("density", state.density, "kg/m3", above_zero);
    state.viscosity = s.number("viscosity", state.viscosity, "Pa s", above_zero);
    study.refuse_left_air = s.choice("outside", "refuse", {"refuse", "end"}) == "refuse";
    const auto heights = s.numbers("heights", "m", 0), along = s.numbers("along_x", "m/s", 0),
               across = s.numbers("along_y", "m/s", 0);
    const auto openfoam = s.text("openfoam");
    const auto time = s.number("time", "s");
    if (openfoam && heights) s.fail("openfoam", "expected a field of OpenFOAM or a table of heights, not both");
    if (!openfoam && time) s.fail("time", "expected the case that has this time: openfoam");
    if (!heights && (along || across)) s.fail(along ? "along_x" : "along_y", "a table needs heights");
    if (heights) {
        if (!along || along->size() != heights->size() || (across && across->size() != heights->size()))
            s.fail("heights", "expected along_x (and along_y, if given) with as many values as heights");
        std::vector<AirTable::Row> rows;
        for (std::size_t i = 0; i < heights->size(); ++i) {
            AirState at = state;
            at.velocity = {(*along)[i], across ? (*across)[i] : 0, 0};
            rows.push_back({(*heights)[i], at});
        }
        try {
            study.air = std::make_shared<AirTable>(std::move(rows));
        } catch (const InputError& e) { s.fail("heights", e.what()); }
    } else if (openfoam) {
        try {
            study.air = std::make_shared<FoamAir>(document.path(*openfoam), time, state);
        } catch (const InputError& e) { s.fail("openfoam", e.what()); }
    } else {
        study.air = std::make_shared<UniformAir>(state);
    }
    s.finish();
}

void read_flight(Document& document, SprayStudy& study) {
    Section s = document.section("flight");
    study.duration = s.number("duration", study.duration, "s", above_zero);
    study.flight.tolerance = s.number("tolerance", study.flight.tolerance, "-", {1e-12, 1e-2});
    study.flight.forces.buoyancy = s.flag("buoyancy", false);
    study.flight.forces.drag = s.choice("drag", "schiller_naumann", {"schiller_naumann", "putnam"}) == "putnam"
                                   ? DragLaw::putnam
                                   : DragLaw::schiller_naumann;
    study.flight.falls_back = s.flag("falls_back", true);
    study.flight.water_level = s.number("water_level", 0, "m");
    s.finish();
}

/// A fan of triangles in a plane.
Surface disc(const Vec3& centre, const Vec3& normal, double radius) {
    constexpr int corners = 72;
    const Sensor plane{centre, normal, 1};
    Surface s;
    s.points.push_back(centre);
    for (int i = 0; i < corners; ++i) {
        const double a = 2 * std::numbers::pi * i / corners;
        s.points.push_back(centre + radius * (std::cos(a) * plane.across() + std::sin(a) * plane.along()));
        s.triangles.push_back({0, i + 1, (i + 1) % corners + 1});
    }
    return s;
}

void read_targets(Document& document, SprayStudy& study) {
    for (Section& s : document.list("target")) {
        TargetSurface t;
        t.name = s.identifier("name", "target");
        const auto file = s.text("file");
        const auto centre = s.vector("centre", "m"), normal = s.vector("normal", "-");
        const auto radius = s.number("radius", "m", above_zero);
        const std::string unit = s.text("unit", "m");
        if (file && centre) s.fail("file", "expected a surface's file, or a disc, not both");
        if (file)
            t.surface = read_surface(document.path(*file), unit);
        else if (centre && normal && radius && normal->norm() > 0)
            t.surface = disc(*centre, *normal, *radius);
        else
            s.fail("name", "expected a surface: file, or centre, normal and radius of a disc");
        s.finish();
        study.targets.push_back(std::move(t));
    }
}

void read_sensor(Document& document, SprayStudy& study) {
    Section s = document.section("sensor");
    if (!s.present()) return;
    SensorStudy& sensor = study.sensor.emplace();
    const auto centre = s.vector("centre", "m"), normal = s.vector("normal", "-");
    if (!centre) s.fail("centre", "missing; expected e.g. centre = [0.2, 0, 0.3]");
    if (!normal || !(normal->norm() > 0)) s.fail("normal", "missing; expected a direction, e.g. [1, 0, 0]");
    sensor.sensor.centre = *centre, sensor.sensor.normal = *normal;
    sensor.sensor.extent = s.number("extent", sensor.sensor.extent, "m", above_zero);
    sensor.window.edge = s.number("window", sensor.window.edge, "m", above_zero);
    if (sensor.window.edge > sensor.sensor.extent) s.fail("window", "is wider than the sensor's extent");
    sensor.window.length = s.number("time_window", sensor.window.length, "s", above_zero);
    sensor.edges = s.numbers("windows", "m", 0).value_or(sensor.edges);
    sensor.lengths = s.numbers("time_windows", "s", 0).value_or(sensor.lengths);
    for (const double edge : sensor.edges)
        if (!(edge > 0)) s.fail("windows", "expected edges above 0");
    for (const double length : sensor.lengths)
        if (!(length > 0)) s.fail("time_windows", "expected times above 0");
    sensor.load.shape = s.choice("pulse", "root", {"root", "study"}) == "root" ? PulseShape::root : PulseShape::study;
    sensor.load.keep_outside = s.choice("outside_law", "keep", {"keep", "leave"}) == "keep";
    sensor.load.sampling = s.number("sampling", sensor.load.sampling, "s", above_zero);
    sensor.load.repeats = static_cast<int>(s.number("repeats", sensor.load.repeats, "-", {1, 1e6}));
    sensor.load.seed = static_cast<std::uint64_t>(s.number("seed", 1, "-", {0, 1e15}));
    sensor.face = s.number("face", sensor.face, "m", above_zero);
    sensor.measured = s.numbers("measured", "Pa", 0).value_or(sensor.measured);
    if (sensor.measured.size() == 1) s.fail("measured", "expected two repeats or more");
    for (const double p : sensor.measured)
        if (!(p > 0)) s.fail("measured", "expected pressures above 0");
    sensor.draws = static_cast<int>(s.number("draws", sensor.draws, "-", {40, 1e6}));
    s.finish();
}

}  // namespace

std::vector<Droplet> read_droplets(const fs::path& file) {
    const CsvColumns csv(read_text(file), file.string());
    const auto column = [&](const char* name) -> const std::vector<double>& {
        const auto found = csv.find(name);
        if (found.size() != 1)
            throw InputError(
                fmt::format("{}: expected one column \"{}\"; it has: {}", file.string(), name, csv.header_list()));
        return csv.values(found.front());
    };
    const auto &x = column("x [m]"), &y = column("y [m]"), &z = column("z [m]"), &u = column("u [m/s]"),
               &v = column("v [m/s]"), &w = column("w [m/s]"), &d = column("diameter [m]"), &t = column("time [s]");
    std::vector<Droplet> droplets;
    for (std::size_t i = 0; i < csv.rows(); ++i) {
        if (!(d[i] > 0))
            throw InputError(
                fmt::format("{}:{}: a diameter of {:g} m; expected above 0", file.string(), csv.line(i), d[i]));
        droplets.push_back({{x[i], y[i], z[i]}, {u[i], v[i], w[i]}, d[i], t[i]});
    }
    return droplets;
}

spray::SprayStudy read_spray_study(const fs::path& file) {
    Document document(file);
    SprayStudy study;
    study.title = document.root().text("title", "");
    read_source(document, study);
    read_water(document, study);
    read_extraction(document, study);
    read_air(document, study);
    read_flight(document, study);
    read_targets(document, study);
    read_sensor(document, study);
    document.root().finish();
    return study;
}

}  // namespace tw::app

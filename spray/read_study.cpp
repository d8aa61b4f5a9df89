#include "spray/read_study.h"

#include <fmt/format.h>

#include "base/read_file.h"
#include "base/errors.h"
#include "record/run_record.h"
#include "spray/air/foam_air.h"
#include "spray/read_droplets.h"
#include "text/section.h"

namespace tw::spray {
namespace {

namespace fs = std::filesystem;

constexpr Range above_zero{1e-300, 1e300};
constexpr Range share{0, 1};

/// A path of the study, which is relative to it.
fs::path beside(const Section& s, const std::string& path) { return s.file().parent_path() / path; }

void read_source(Section s, SprayStudy& study) {
    if (!s.present()) s.fail("sph", "missing; expected [source] with sph, taken, fvm or table");
    if (const auto run = s.text("sph")) study.source.sph = beside(s, *run);
    if (const auto run = s.text("taken")) study.source.taken = beside(s, *run);
    if (const auto run = s.text("fvm")) study.source.fvm = beside(s, *run);
    if (const auto table = s.text("table")) study.source.droplets = read_droplets(beside(s, *table));
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

void read_water(Section s, SprayStudy& study) {
    Liquid& l = study.extraction.liquid;
    l.density = s.number("density", l.density, "kg/m3", above_zero);
    l.viscosity = s.number("viscosity", l.viscosity, "Pa s", above_zero);
    l.surface_tension = s.number("surface_tension", l.surface_tension, "N/m", above_zero);
    study.extraction.gravity.z() = -s.number("gravity", -study.extraction.gravity.z(), "m/s2");
    s.finish();
}

void read_extraction(Section s, SprayStudy& study) {
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
    if (surface) o.gate = Gate::surface(read_surface(beside(s, *surface)));
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

void read_air(Section s, SprayStudy& study) {
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
            study.air = std::make_shared<FoamAir>(beside(s, *openfoam), time, state);
        } catch (const InputError& e) { s.fail("openfoam", e.what()); }
    } else {
        study.air = std::make_shared<UniformAir>(state);
    }
    s.finish();
}

void read_flight(Section s, SprayStudy& study) {
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

void read_target(Section& s, SprayStudy& study) {
    TargetSurface t;
    t.name = s.identifier("name", "target");
    const auto file = s.text("file");
    const auto centre = s.vector("centre", "m"), normal = s.vector("normal", "-");
    const auto radius = s.number("radius", "m", above_zero);
    const std::string unit = s.text("unit", "m");
    if (file && centre) s.fail("file", "expected a surface's file, or a disc, not both");
    if (file)
        t.surface = read_surface(beside(s, *file), unit);
    else if (centre && normal && radius && normal->norm() > 0)
        t.surface = disc(*centre, *normal, *radius);
    else
        s.fail("name", "expected a surface: file, or centre, normal and radius of a disc");
    s.finish();
    study.targets.push_back(std::move(t));
}

void read_sensor(Section s, SprayStudy& study) {
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

SprayStudy read_spray_study(const fs::path& file) {
    const TextValue document = parse_document(read_text_within(file, largest_document), file);
    Section root(file, "", &document);
    SprayStudy study;
    study.title = root.text("title", "");
    read_source(root.section("source"), study);
    read_water(root.section("water"), study);
    read_extraction(root.section("extraction"), study);
    read_air(root.section("air"), study);
    read_flight(root.section("flight"), study);
    for (Section& target : root.sections("target")) read_target(target, study);
    read_sensor(root.section("sensor"), study);
    root.finish();
    return study;
}

}  // namespace tw::spray

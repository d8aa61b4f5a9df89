#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "app/arguments/output.h"
#include "app/runs/facts_json.h"
#include "base/errors.h"
#include "meshes/generate.h"
#include "meshes/read/named_solid.h"
#include "meshes/read/solids_of_file.h"
#include "meshes/surface.h"
#include "scene/solids/hull_axes.h"
#include "text/did_you_mean.h"
#include "text/units.h"

namespace tw::app {
namespace {

HullFacts hull_facts(const std::string& source, const Surface& surface, double particle_spacing) {
    HullFacts f;
    f.source = source;
    f.points = surface.points.size();
    f.triangles = surface.triangles.size();
    f.bounds = surface.bounds();
    f.findings = check_surface(surface, particle_spacing);
    f.usable = usable(f.findings);
    f.mass = mass_properties(surface);
    f.hash = surface_hash(surface);
    return f;
}

std::string text_of(const HullFacts& f) {
    const Vec3 size = f.bounds.size();
    std::string out = fmt::format("{}\n  {} points, {} triangles, {:.6g} x {:.6g} x {:.6g} m\n", f.source, f.points,
                                  f.triangles, size.x(), size.y(), size.z());
    out += fmt::format("  from ({:.6g}, {:.6g}, {:.6g}) to ({:.6g}, {:.6g}, {:.6g}) m\n", f.bounds.min.x(),
                       f.bounds.min.y(), f.bounds.min.z(), f.bounds.max.x(), f.bounds.max.y(), f.bounds.max.z());
    out +=
        fmt::format("  volume {:.6g} m3, area {:.6g} m2, centroid ({:.6g}, {:.6g}, {:.6g}) m\n  sha256 {}\n",
                    f.mass.volume, f.mass.area, f.mass.centroid.x(), f.mass.centroid.y(), f.mass.centroid.z(), f.hash);
    if (!f.solids.empty()) out += "  solids by name: " + names_in_words(f.solids) + "\n";
    static constexpr const char* levels[] = {"note", "warning", "error"};
    for (const std::string& r : f.repairs) out += "  repaired: " + r + "\n";
    for (const Finding& finding : f.findings)
        out += fmt::format("  {}: {}: {}{}\n", levels[static_cast<int>(finding.level)], finding.name, finding.message,
                           finding.mendable ? "; \"twinwake hull repair\" repairs it" : "");
    return out + (f.usable ? "  usable: yes\n" : "  usable: no\n");
}

/// Only STL is written. A surface is not written over the file that it was read from.
void check_output(const HullCommand& command) {
    const std::filesystem::path& out = command.out;
    if (out.empty())
        throw InputError(fmt::format("hull make {}: no file to write; expected -o FILE.stl", command.shape));
    std::string suffix = out.extension().string();
    std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (suffix != ".stl") throw InputError(out.string() + ": only STL is written; expected a name that ends in .stl");
    std::error_code none;
    if (std::filesystem::equivalent(command.in, out, none))
        throw InputError(
            fmt::format("{}: is the input file, which would be overwritten; choose another name for the "
                        "output",
                        out.string()));
}

Surface made(const HullCommand& command) {
    const auto& shapes = hull_shapes();
    const auto shape =
        std::find_if(shapes.begin(), shapes.end(), [&](const HullShape& s) { return s.name == command.shape; });
    if (shape == shapes.end()) return make_hull(command.shape, {});  // its message names the known shapes
    std::vector<std::string> known;
    for (const HullParameter& p : shape->parameters) known.push_back(p.name);
    std::map<std::string, double> values;
    for (const std::string& word : command.parameters) {
        const std::size_t equals = word.find('=');
        const std::string name = word.substr(0, equals);
        const auto p = std::find_if(shape->parameters.begin(), shape->parameters.end(),
                                    [&](const HullParameter& q) { return q.name == name; });
        std::string list;
        for (const std::string& k : known) list += (list.empty() ? "" : ", ") + k;
        if (equals == std::string::npos || p == shape->parameters.end())
            throw InputError(fmt::format("{}: expected name=value; {} knows: {}{}", word, command.shape, list,
                                         did_you_mean(name, known)));
        try {
            values[name] = quantity(word.substr(equals + 1), p->kind);
        } catch (const UnitError& e) { throw InputError(word + ": " + e.what()); }
    }
    return make_hull(command.shape, values);
}

std::string shapes_text() {
    std::string out;
    for (const HullShape& shape : hull_shapes()) {
        out += fmt::format("{}: {}\n", shape.name, shape.description);
        for (const HullParameter& p : shape.parameters)
            out += fmt::format("  {:16} {} [{}], {:.6g} unless given, {:.6g} to {:.6g}\n", p.name, p.meaning, p.kind,
                               p.fallback, p.min, p.max);
    }
    return out;
}

}  // namespace

int run_hull(const HullCommand& command, const Common& common) {
    if (command.action == "make" && command.shape.empty()) {
        say(common, shapes_text());
        return done;
    }
    if (command.action != "info") check_output(command);
    Surface surface = command.action == "make" ? made(command) : read_surface(command.in, command.unit, command.axes);
    std::vector<Finding> notes;
    if (command.action != "make")
        if (const auto mirrored = mirror_half(surface)) notes.push_back(*mirrored);
    std::vector<std::string> repairs;
    if (command.action == "repair") {
        Repaired repaired = repair_surface(surface);
        surface = std::move(repaired.surface);
        repairs = std::move(repaired.done);
    }
    HullFacts facts =
        hull_facts(command.action == "make" ? command.shape : command.in.string(), surface, command.particle_spacing);
    facts.repairs = repairs;
    if (command.action == "info" && named_solid(command.in).name.empty()) facts.solids = solids_of_file(command.in);
    if (facts.usable) std::ranges::copy(check_axes(surface), std::back_inserter(notes));
    facts.findings.insert(facts.findings.end(), notes.begin(), notes.end());
    if (command.action == "repair" && !facts.usable) {
        say(common, text_of(facts));
        throw InputError(command.in.string() +
                         ": could not be repaired safely; nothing was written. The findings above name the places");
    }
    if (command.action != "info") write_stl(command.out, surface);
    say(common, text_of(facts) + (command.action == "info" ? "" : "  written: " + command.out.string() + "\n"));
    write_json(common, hull_json(facts));
    return command.action == "info" && !facts.usable ? bad_input : done;
}

}  // namespace tw::app

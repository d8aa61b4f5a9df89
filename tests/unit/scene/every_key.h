#pragma once
// A small sound scene for every key of the scene's table.
#include <map>
#include <string>

#include "base/atomic_file.h"
#include "meshes/surface.h"
#include "scene_text.h"

namespace tw::test {

inline const std::string tank =
    "[tank]\nsize = [1, 0.5, 0.8]\n[[water_block]]\nmin = [0, 0, 0]\nmax = [0.5, 0.5, 0.4]\n"
    "[[obstacle]]\nmin = [0.7, 0, 0]\nmax = [0.8, 0.5, 0.2]\n[[probe]]\npressure = [1, 0.2, 0.1]\n"
    "[[probe]]\nheight = [0.6, 0.2]\n[resolution]\nnear_hull = 0.05\n";

/// A scene in which a key has a value, and the same with another one.
struct Change {
    std::string before, after;
};

/// `scene` with a key set one way and the other.
inline Change set(const std::string& scene, const std::string& section, const std::string& key,
                  const std::string& before, const std::string& after) {
    const auto one = [&](const std::string& value) {
        const std::string header = "[" + section + "]\n", line = key + " = " + value + "\n";
        return scene.find(header) == std::string::npos ? scene + header + line : with(scene, header, header + line);
    };
    return {one(before), one(after)};
}
inline Change replaced(const std::string& scene, const std::string& from, const std::string& to) {
    return {scene, with(scene, from, to)};
}

/// One change for every key of the table, by "section.key".
inline std::map<std::string, Change> changes() {
    // Defaults that follow from other keys are fixed, so that each key is seen by itself.
    const std::string stream = with(planing, "[motion]\n", "[motion]\nramp = 0.1\n") +
                               "[sampling]\ninterval = 0.02\nmean_from = 0.7\n[sph]\nc0 = 100\n";
    const std::string fixed = stream + "[domain]\nx = [-3, 5]\ny = [-2, 2]\nz = [-1.6, 2]\n";
    const std::string cavitating = fixed + "[effects]\ncavitation = \"on\"\n",
                      rough = fixed + "[effects]\nviscosity = \"on\"\nturbulence = \"on\"\n",
                      damped = fixed + "[effects]\nacoustic_damping = \"on\"\n",
                      airy = tank + "[effects]\nair = \"on\"\n", zoned = "[effects]\nforcing_zones = \"on\"\n";
    const std::string gated = with(fixed, "[sph]\n", "[sph]\ngate_point = [0, 0, 0.3]\ngate_normal = [0, 0, 1]\n");
    const std::string wavy =
        "[tank]\nmin = [-2, 0, -0.24]\nmax = [1.6, 0.01, 0.12]\n[domain]\ndimensions = 2\n[wave]\nheight = 0.04\n"
        "length = 1\n[resolution]\nnear_hull = 0.01\n[run]\nduration = 1\n[sampling]\ninterval = 0.02\n"
        "mean_from = 0.7\n[sph]\nc0 = 100\n";
    const auto sea = [&](const std::string& wave) {
        return "[tank]\nmin = [-4, 0, -0.4]\nmax = [4, 0.02, 0.2]\n[domain]\ndimensions = 2\n[wave]\n" + wave +
               "[resolution]\nnear_hull = 0.0125\n[run]\nduration = 1\n[sampling]\ninterval = 0.02\nmean_from = 0.7\n"
               "[sph]\nc0 = 100\n";
    };
    const std::string random =
                          sea("spectrum = \"jonswap\"\nsignificant_height = 0.06\npeak_period = 1\npeakedness = 3.3\n"
                              "components = 60\nseed = 1\n"),
                      two_waves =
                          sea("spectrum = \"bichromatic\"\nheight = 0.04\nperiod = 1\nsecond_height = 0.03\n"
                              "second_period = 0.8\n"),
                      focused =
                          sea("spectrum = \"focused\"\ncrest = 0.06\npeak_period = 1\nfocus_place = 0.5\n"
                              "focus_time = 5\n");
    const std::string sluice =
        "[motion]\nkind = \"stream\"\nspeed = 0.4\nramp = 0.1\n[domain]\nx = [-1, 2]\nz = [-0.4, 0.3]\ndimensions = 2\n"
        "[resolution]\nnear_hull = 0.01\n[run]\nduration = 1\n[sampling]\ninterval = 0.02\n[sph]\nc0 = 100\n"
        "[[obstacle]]\nmin = [0, -1, -0.3]\nmax = [0.02, 1, 0.2]\n";
    const Surface hull = scene_of(planing).hull->surface;
    write_stl(scratch() / "a.stl", hull);
    write_stl(scratch() / "b.stl", scene_of(with(planing, "20 deg", "15 deg")).hull->surface);
    const std::string from_file =
        with(fixed, "shape    = \"prismatic\"\nlength   = \"4 m\"\nbeam     = \"1 m\"\ndeadrise = \"20 deg\"\n",
             "file = \"a.stl\"\n");
    const std::string with_shape =
        with(tank, "min = [0.7, 0, 0]\nmax = [0.8, 0.5, 0.2]",
             "shape = \"box\"\nlength = 0.1\nbeam = 0.1\nheight = 0.1\nposition = [0.7, 0.2, 0.1]");
    write_stl(scratch() / "block.stl", scene_of(with_shape).obstacles[0].surface);
    write_stl(scratch() / "block2.stl", scene_of(with(with_shape, "0.2, 0.1]", "0.2, 0.2]")).obstacles[0].surface);
    const std::string block_file = with(tank, "min = [0.7, 0, 0]\nmax = [0.8, 0.5, 0.2]", "file = \"block.stl\"");
    const std::string lifted = with(tank, "size = [1, 0.5, 0.8]", "min = [0, 0, 0]\nmax = [1, 0.5, 0.8]");
    const std::string afloat =
        "[tank]\nmin = [-1, -1, -1]\nmax = [1, 1, 1]\n[resolution]\nnear_hull = 0.05\n[[body]]\nshape = \"box\"\n"
        "length = 0.4\nbeam = 0.3\nheight = 0.2\ndraft = 0.1\ndensity = 500\n";
    write_stl(scratch() / "ball.stl", scene_of(afloat).bodies[0].surface);
    write_stl(scratch() / "ball2.stl", scene_of(with(afloat, "length = 0.4", "length = 0.5")).bodies[0].surface);
    const std::string body_file =
        with(afloat, "shape = \"box\"\nlength = 0.4\nbeam = 0.3\nheight = 0.2\n", "file = \"ball.stl\"\n");
    const std::string moved = with(afloat, "density = 500\n", "motion = \"prescribed\"\n");
    const std::string constant = moved + "law = \"constant\"\nalong = [1, 0, 0]\nrate = 1\n",
                      ramped = moved + "law = \"ramp\"\nalong = [1, 0, 0]\nrate = 1\nramp = 0.1\n",
                      swaying =
                          moved + "law = \"sinusoid\"\nalong = [1, 0, 0]\namplitude = 0.1\nperiod = 2\nphase = 0\n",
                      tabled = moved + "law = \"table\"\nalong = [1, 0, 0]\ntimes = [0, 1]\nvalues = [0, 0.1]\n";
    const std::string boxed_water = tank + "[[volume]]\nname = \"behind\"\nmin = [0.8, 0, 0]\nmax = [1, 0.5, 2]\n";
    const std::string weighed =
        planing +
        "[[measured]]\nquantity = \"lift\"\nvalue = \"71.25 N\"\nuncertainty = \"3 N\"\nsource = \"Tank 3\"\n";
    const std::string forced =
        wavy + "[[measured]]\nquantity = \"wave_force_x\"\nvalue = \"3 N\"\nsource = \"Tank 3\"\n";
    const auto tank_with = [](const std::string& motion) {
        return with(tank, "size = [1, 0.5, 0.8]\n", "size = [1, 0.5, 0.8]\n" + motion) + "[sph]\nc0 = 100\n";
    };
    const std::string tank_constant = tank_with("law = \"constant\"\nalong = [1, 0, 0]\nrate = 1\n"),
                      tank_ramped = tank_with("law = \"ramp\"\nalong = [1, 0, 0]\nrate = 1\nramp = 0.1\n"),
                      tank_rolling = tank_with(
                          "law = \"ramp\"\nabout = [1, 0, 0]\nrate = 1\nramp = 0.1\n"
                          "pivot = [0, 0, 0]\n"),
                      tank_swaying = tank_with(
                          "law = \"sinusoid\"\nalong = [1, 0, 0]\namplitude = 0.1\nperiod = 2\n"
                          "phase = 0\n"),
                      tank_tabled =
                          tank_with("law = \"table\"\nalong = [1, 0, 0]\ntimes = [0, 1]\nvalues = [0, 0.1]\n");
    const auto more = [&](const std::string& key, const std::string& before, const std::string& after) {
        return Change{afloat + key + " = " + before + "\n", afloat + key + " = " + after + "\n"};
    };
    const std::string distances =
        with(stream, "[motion]", "[domain]\nahead = 1\nbehind = 4\nside = 2\nbelow = 2\nabove = 2\n[motion]");
    const std::string boxed = fixed + "[[refine]]\nmin = [2, -0.5, -0.4]\nmax = [3, 0.5, 0.2]\nspacing = 0.05\n";
    const std::string around = fixed + "[[refine]]\naround = \"wake\"\nspacing = 0.05\n";
    const std::string held =
        with(with(dropped,
                  "[[gauge]]\nname = \"strain\"\nposition = [\"30 mm\", 0, \"0.5 m\"]\ndirection = [1, 0, 0]\n", ""),
             "carried = [\"x_min\", \"x_max\", \"y_min\", \"y_max\"]\nmass = \"5 kg\"\nvelocity = [0, 0, \"-2 m/s\"]",
             "clamped = [\"x_min\"]");
    for (const char* name : {"a.inp", "b.inp"})
        write_text_atomically(scratch() / name, sheet_mesh(name[0] == 'a' ? 0.2 : 0.3));
    const std::string meshed = with(with(dropped, "plate = [\"0.4 m\", \"0.2 m\"]\ncells = [8, 4]", "mesh = \"a.inp\""),
                                    "\"x_min\", \"x_max\", \"y_min\", \"y_max\"", "\"ENDS\"");
    const std::string isotropic =
        with(with(dropped,
                  "[[ply]]\nname = \"C\"\nthickness = \"1 mm\"\nE1 = \"60 GPa\"\nE2 = \"10 GPa\"\nnu12 = 0.25\n"
                  "G12 = \"4 GPa\"\ndensity = \"1500 kg/m3\"\n",
                  ""),
             "layup = \"[0 C/90 C]s\"", "thickness = 0.004\nyoungs_modulus = 6e10\npoisson = 0.3\ndensity = 2000");
    const std::string free_hull = with(fixed, "half     = true\n",
                                       "half     = true\nfree = [\"heave\", \"pitch\"]\nmass = 300\nlcg = 1.6\n"
                                       "vcg = 0.3\npitch_gyradius = 1\n");
    std::map<std::string, Change> all{
        {".title", replaced(fixed, "title = \"planing\"", "title = \"other\"")},
        {"hull.file", replaced(from_file, "a.stl", "b.stl")},
        {"hull.shape",
         replaced(fixed, "shape    = \"prismatic\"\nlength   = \"4 m\"\nbeam     = \"1 m\"\ndeadrise = \"20 deg\"",
                  "shape = \"box\"\nlength = 4\nbeam = 1")},
        {"hull.unit",
         {with(from_file, "half     = true", "unit = \"m\""),
          with(with(from_file, "half     = true", "unit = \"ft\""), "\"0.05 m\"", "0.05")}},
        {"hull.axes", set(with(from_file, "half     = true\n", ""), "hull", "axes", "\"xyz\"", "\"-x-yz\"")},
        {"hull.trim", replaced(fixed, "5 deg", "6 deg")},
        {"hull.heel", set(with(fixed, "half     = true\n", ""), "hull", "heel", "0", "\"2 deg\"")},
        {"hull.draft", replaced(fixed, "draft    = \"0.2 m\"", "draft    = \"0.21 m\"")},
        {"hull.position", set(fixed, "hull", "position", "[0, 0]", "[0.1, 0]")},
        {"hull.half", replaced(fixed, "half     = true", "half     = false")},
        {"hull.free", replaced(free_hull, "[\"heave\", \"pitch\"]", "[\"heave\"]")},
        {"hull.mass", replaced(free_hull, "mass = 300", "mass = 301")},
        {"hull.lcg", replaced(free_hull, "lcg = 1.6", "lcg = 1.61")},
        {"hull.vcg", replaced(free_hull, "vcg = 0.3", "vcg = 0.31")},
        {"hull.pitch_gyradius", replaced(free_hull, "gyradius = 1", "gyradius = 1.1")},
        {"hull.release", {with(free_hull, "lcg", "release = 0.2\nlcg"), with(free_hull, "lcg", "release = 0.3\nlcg")}},
        {"water.depth", set(planing, "water", "depth", "0.9", "1")},
        {"motion.kind", {planing, with(planing, "kind  = \"stream\"\nspeed = \"8 m/s\"", "kind = \"none\"")}},
        {"motion.speed", replaced(fixed, "8 m/s", "8.1 m/s")},
        {"motion.ramp", replaced(fixed, "ramp = 0.1", "ramp = 0.2")},
        {"resolution.near_hull", replaced(fixed, "0.05 m", "0.04 m")},
        {"resolution.spacing", set(fixed, "resolution", "spacing", "0.1", "0.2")},
        {"domain.ahead", replaced(distances, "ahead = 1", "ahead = 1.2")},
        {"domain.behind", replaced(distances, "behind = 4", "behind = 5")},
        {"domain.side", replaced(distances, "side = 2", "side = 2.5")},
        {"domain.below", replaced(distances, "below = 2", "below = 2.5")},
        {"domain.above", replaced(distances, "above = 2", "above = 2.5")},
        {"domain.x", replaced(fixed, "x = [-3, 5]", "x = [-3, 5.1]")},
        {"domain.y", replaced(fixed, "y = [-2, 2]", "y = [-2.1, 2.1]")},
        {"domain.z", replaced(fixed, "z = [-1.6, 2]", "z = [-1.6, 2.1]")},
        {"domain.dimensions", {tank, tank + "[domain]\ndimensions = 2\n"}},
        {"run.duration", replaced(fixed, "1.5 s", "1.6 s")},
        {"run.methods", replaced(fixed, "[\"sph\", \"fvm\"]", "[\"sph\"]")},
        {"sampling.interval", replaced(fixed, "interval = 0.02", "interval = 0.03")},
        {"sampling.mean_from", replaced(fixed, "mean_from = 0.7", "mean_from = 0.8")},
        {"sampling.cuts_x", set(fixed, "sampling", "cuts_x", "[0]", "[1]")},
        {"sampling.cuts_y", set(fixed, "sampling", "cuts_y", "[0]", "[1]")},
        {"probe.name",
         {with(tank, "[[probe]]\n", "[[probe]]\nname = \"A\"\n"),
          with(tank, "[[probe]]\n", "[[probe]]\nname = \"B\"\n")}},
        {"probe.filter",
         {with(tank, "[[probe]]\n", "[[probe]]\nfilter = 0.002\n"),
          with(tank, "[[probe]]\n", "[[probe]]\nfilter = 0.001\n")}},
        {"probe.slam",
         {wavy + "[[probe]]\npressure = [0, 0, -0.1]\nslam = 1000\n",
          wavy + "[[probe]]\npressure = [0, 0, -0.1]\nslam = 2000\n"}},
        {"probe.deck",
         {wavy + "[[probe]]\nheight = [0, 0]\ndeck = 0\n", wavy + "[[probe]]\nheight = [0, 0]\ndeck = 0.01\n"}},
        {"probe.pressure", replaced(tank, "pressure = [1, 0.2, 0.1]", "pressure = [1, 0.2, 0.2]")},
        {"probe.height", replaced(tank, "height = [0.6, 0.2]", "height = [0.6, 0.3]")},
        {"tank.size", replaced(tank, "size = [1, 0.5, 0.8]", "size = [1, 0.5, 0.9]")},
        {"tank.min", replaced(lifted, "min = [0, 0, 0]\nmax = [1, 0.5", "min = [-0.1, 0, 0]\nmax = [1, 0.5")},
        {"tank.max", replaced(lifted, "max = [1, 0.5, 0.8]", "max = [1.1, 0.5, 0.8]")},
        {"tank.law", {tank_constant, tank_ramped}},
        {"tank.along", replaced(tank_constant, "along = [1, 0, 0]", "along = [0, 0, 1]")},
        {"tank.about", replaced(tank_rolling, "about = [1, 0, 0]", "about = [0, 1, 0]")},
        {"tank.pivot", replaced(tank_rolling, "pivot = [0, 0, 0]", "pivot = [0, 0, 0.1]")},
        {"tank.rate", replaced(tank_constant, "rate = 1", "rate = 1.1")},
        {"tank.ramp", replaced(tank_ramped, "ramp = 0.1", "ramp = 0.2")},
        {"tank.amplitude", replaced(tank_swaying, "amplitude = 0.1", "amplitude = 0.11")},
        {"tank.period", replaced(tank_swaying, "period = 2", "period = 2.1")},
        {"tank.phase", replaced(tank_swaying, "phase = 0", "phase = 0.1")},
        {"tank.times", replaced(tank_tabled, "times = [0, 1]", "times = [0, 1.1]")},
        {"tank.values", replaced(tank_tabled, "values = [0, 0.1]", "values = [0, 0.11]")},
        {"water_block.min",
         replaced(tank, "min = [0, 0, 0]\nmax = [0.5, 0.5, 0.4]", "min = [0.1, 0, 0]\nmax = [0.5, 0.5, 0.4]")},
        {"water_block.max", replaced(tank, "max = [0.5, 0.5, 0.4]", "max = [0.4, 0.5, 0.4]")},
        {"volume.name", replaced(boxed_water, "\"behind\"", "\"before\"")},
        {"volume.min", replaced(boxed_water, "min = [0.8, 0, 0]", "min = [0.82, 0, 0]")},
        {"volume.max", replaced(boxed_water, "max = [1, 0.5, 2]", "max = [1, 0.5, 0.7]")},
        {"measured.quantity", replaced(weighed, "\"lift\"", "\"drag\"")},
        {"measured.value", replaced(weighed, "71.25 N", "70 N")},
        {"measured.uncertainty", replaced(weighed, "3 N", "4 N")},
        {"measured.source", replaced(weighed, "Tank 3", "Tank 4")},
        {"measured.speed", {weighed, weighed + "speed = 3\n"}},
        {"measured.wave_length", {forced, forced + "wave_length = 3\n"}},
        {"refine.name", {boxed, with(boxed, "[[refine]]\n", "[[refine]]\nname = \"a\"\n")}},
        {"refine.min", replaced(boxed, "min = [2, -0.5, -0.4]", "min = [2.2, -0.5, -0.4]")},
        {"refine.max", replaced(boxed, "max = [3, 0.5, 0.2]", "max = [3.2, 0.5, 0.2]")},
        {"refine.around", replaced(around, "around = \"wake\"", "around = \"free_surface\"")},
        {"refine.width", {around, around + "width = 0.3\n"}},
        {"refine.length", {around, around + "length = 1\n"}},
        {"refine.spacing", replaced(boxed, "spacing = 0.05", "spacing = 0.11")},
        {"obstacle.name",
         {with(tank, "[[obstacle]]\n", "[[obstacle]]\nname = \"A\"\n"),
          with(tank, "[[obstacle]]\n", "[[obstacle]]\nname = \"B\"\n")}},
        {"obstacle.min", replaced(tank, "min = [0.7, 0, 0]", "min = [0.6, 0, 0]")},
        {"obstacle.max", replaced(tank, "max = [0.8, 0.5, 0.2]", "max = [0.9, 0.5, 0.2]")},
        {"obstacle.file", replaced(block_file, "block.stl", "block2.stl")},
        {"obstacle.shape", replaced(with_shape, "shape = \"box\"\nlength = 0.1\nbeam = 0.1\nheight = 0.1",
                                    "shape = \"sphere\"\ndiameter = 0.1")},
        {"obstacle.unit", {block_file, with(block_file, "file =", "unit = \"ft\"\nfile =")}},
        {"obstacle.axes", {block_file, with(block_file, "file =", "axes = \"y-xz\"\nposition = [0.3, 1, 0]\nfile =")}},
        {"obstacle.position", replaced(with_shape, "position = [0.7, 0.2, 0.1]", "position = [0.7, 0.2, 0.2]")},
        {"body.name", more("name", "\"A\"", "\"B\"")},
        {"body.file", replaced(body_file, "ball.stl", "ball2.stl")},
        {"body.shape", replaced(afloat, "shape = \"box\"\nlength = 0.4\nbeam = 0.3\nheight = 0.2",
                                "shape = \"sphere\"\ndiameter = 0.2")},
        {"body.unit", {body_file, with(body_file, "file =", "unit = \"ft\"\nfile =")}},
        {"body.axes", {body_file, with(body_file, "file =", "axes = \"y-xz\"\nfile =")}},
        {"body.filter", more("filter", "0.002", "0.001")},
        {"body.trim", more("trim", "0", "0.1")},
        {"body.heel", more("heel", "0", "0.1")},
        {"body.draft", replaced(afloat, "draft = 0.1", "draft = 0.15")},
        {"body.position", more("position", "[0, 0]", "[0.1, 0]")},
        {"body.density", replaced(afloat, "density = 500", "density = 600")},
        {"body.mass", replaced(with(afloat, "density = 500", "mass = 5"), "mass = 5", "mass = 6")},
        {"body.centre", more("centre", "[0, 0, 0]", "[0, 0, -0.01]")},
        {"body.inertia", more("inertia", "[1, 1, 1]", "[1, 1, 1.1]")},
        {"body.motion", {afloat, with(constant, "rate = 1", "rate = 0")}},
        {"body.locked", more("locked", "[\"yaw\"]", "[\"sway\"]")},
        {"body.velocity", more("velocity", "[0, 0, 0]", "[0, 0, 0.1]")},
        {"body.speed", more("speed", "0", "0.1")},
        {"body.spin", more("spin", "[0, 0, 0]", "[0, 0.1, 0]")},
        {"body.friction", more("friction", "0.5", "0.6")},
        {"body.law", {constant, ramped}},
        {"body.along", replaced(constant, "along = [1, 0, 0]", "along = [0, 0, 1]")},
        {"body.about", {with(constant, "along", "about"), with(constant, "along = [1, 0, 0]", "about = [0, 0, 1]")}},
        {"body.rate", replaced(constant, "rate = 1", "rate = 1.1")},
        {"body.ramp", replaced(ramped, "ramp = 0.1", "ramp = 0.2")},
        {"body.amplitude", replaced(swaying, "amplitude = 0.1", "amplitude = 0.11")},
        {"body.period", replaced(swaying, "period = 2", "period = 2.1")},
        {"body.phase", replaced(swaying, "phase = 0", "phase = 0.1")},
        {"body.times", replaced(tabled, "times = [0, 1]", "times = [0, 1.1]")},
        {"body.values", replaced(tabled, "values = [0, 0.1]", "values = [0, 0.11]")},
        {"body.elastic", {afloat, dropped}},
        {"body.mesh", replaced(meshed, "a.inp", "b.inp")},
        {"body.coupling_iterations", replaced(dropped, "[8, 4]", "[8, 4]\ncoupling_iterations = 2")},
        {"body.plate", replaced(dropped, "\"0.2 m\"]", "\"0.24 m\"]")},
        {"body.cells", replaced(dropped, "[8, 4]", "[8, 6]")},
        {"body.middle", replaced(held, "[0, 0, \"0.5 m\"]\nlayup", "[0, 0, \"0.49 m\"]\nlayup")},
        {"body.thickness", replaced(isotropic, "thickness = 0.004", "thickness = 0.005")},
        {"body.youngs_modulus", replaced(isotropic, "6e10", "7e10")},
        {"body.poisson", replaced(isotropic, "poisson = 0.3", "poisson = 0.25")},
        {"body.layup", replaced(dropped, "[0 C/90 C]s", "[90 C/0 C]s")},
        {"body.clamped", replaced(held, "clamped = [\"x_min\"]", "clamped = [\"x_max\"]")},
        {"body.hinged", replaced(held, "clamped = [\"x_min\"]", "clamped = [\"x_min\"]\nhinged = [\"x_max\"]")},
        {"body.carried", replaced(dropped, ", \"y_min\", \"y_max\"]", "]")},
        {"body.skin", replaced(dropped, "[8, 4]", "[8, 4]\nskin = 0.13")},
        {"body.margin", replaced(held, "[8, 4]", "[8, 4]\nmargin = 0.1")},
        {"body.rotations", replaced(dropped, "[8, 4]", "[8, 4]\nrotations = \"small\"")},
        {"body.coupling", replaced(dropped, "[8, 4]", "[8, 4]\ncoupling = \"penalty\"")},
        {"body.contact",
         {with(dropped, "[8, 4]", "[8, 4]\ncoupling = \"penalty\""),
          with(dropped, "[8, 4]", "[8, 4]\ncoupling = \"penalty\"\ncontact = \"adaptive\"")}},
        {"body.contact_factor",
         {with(dropped, "[8, 4]", "[8, 4]\ncoupling = \"penalty\""),
          with(dropped, "[8, 4]", "[8, 4]\ncoupling = \"penalty\"\ncontact_factor = 0.1")}},
        {"body.damping", replaced(dropped, "[8, 4]", "[8, 4]\ndamping = 3")},
        {"body.structure_step", replaced(dropped, "[8, 4]", "[8, 4]\nstructure_step = 1e-5")},
        {"body.tyre", replaced(tyre_scene, "[16, 8]", "[16, 8]\ntyre = [0.25, 0.095, 0.081]")},
        {"body.walls", replaced(tyre_scene, "[16, 8]", "[16, 8]\nwalls = [0.01, 0.006, 0.0021]")},
        {"body.tread", replaced(tyre_scene, "[16, 8]", "[16, 8]\ntread = [4e6, 9e5, 1e8]")},
        {"body.sidewall", replaced(tyre_scene, "[16, 8]", "[16, 8]\nsidewall = [4e6, 9e5, 1e8]")},
        {"body.inner_tyre", replaced(tyre_scene, "[16, 8]", "[16, 8]\ninner_tyre = [4e6, 9e5, 1e8]")},
        {"body.pressure", replaced(tyre_scene, "[16, 8]", "[16, 8]\npressure = 1.4e5")},
        {"body.drop_height", replaced(tyre_scene, "[16, 8]", "[16, 8]\ndrop_height = 0.3")},
        {"body.contact_depth", replaced(tyre_scene, "[16, 8]", "[16, 8]\ncontact_depth = 2e-4")},
        {"ply.name", {dropped, with(with(dropped, "name = \"C\"", "name = \"D\""), "[0 C/90 C]s", "[0 D/90 D]s")}},
        {"ply.thickness", replaced(dropped, "\"1 mm\"", "\"2 mm\"")},
        {"ply.E1", replaced(dropped, "60 GPa", "61 GPa")},
        {"ply.E2", replaced(dropped, "10 GPa", "11 GPa")},
        {"ply.nu12", replaced(dropped, "nu12 = 0.25", "nu12 = 0.26")},
        {"ply.G12", replaced(dropped, "\"4 GPa\"", "\"5 GPa\"")},
        {"ply.G13", replaced(dropped, "\"4 GPa\"", "\"4 GPa\"\nG13 = 3e9")},
        {"ply.G23", replaced(dropped, "\"4 GPa\"", "\"4 GPa\"\nG23 = 3e9")},
        {"ply.density", replaced(dropped, "1500", "1600")},
        {"gauge.name", replaced(dropped, "name = \"strain\"", "name = \"other\"")},
        {"gauge.body", replaced(dropped, "name = \"strain\"", "name = \"strain\"\nbody = \"laminate\"")},
        {"gauge.position", replaced(dropped, "30 mm", "40 mm")},
        {"gauge.direction", replaced(dropped, "direction = [1, 0, 0]", "direction = [0, 1, 0]")},
        {"gauge.face", replaced(dropped, "direction = [1, 0, 0]", "direction = [1, 0, 0]\nface = \"bottom\"")},
        {"sph.levels", set(fixed, "sph", "levels", "1", "2")},
        {"sph.gate_point", replaced(gated, "[0, 0, 0.3]", "[0, 0, 0.4]")},
        {"sph.gate_normal", replaced(gated, "[0, 0, 1]", "[1, 0, 1]")},
        {"sph.gate_link", set(gated, "sph", "gate_link", "2", "2.5")},
        {"sph.zone", set(fixed, "sph", "zone", "16", "10")},
        {"sph.wake", set(fixed, "sph", "wake", "0", "2")},
        {"sph.scheme", set(fixed, "sph", "scheme", "\"kick_drift_kick\"", "\"symplectic_euler\"")},
        {"sph.equation_of_state", set(fixed, "sph", "equation_of_state", "\"linear\"", "\"tait\"")},
        {"sph.c0", replaced(fixed, "c0 = 100", "c0 = 101")},
        {"sph.shifting", set(fixed, "sph", "shifting", "1", "2")},
        {"sph.smagorinsky", set(rough, "sph", "smagorinsky", "0.1", "0.2")},
        {"sph.acoustic_damping", set(damped, "sph", "acoustic_damping", "0.1", "0.2")},
        {"domain.sides", set(fixed + zoned, "domain", "sides", "\"open\"", "\"walls\"")},
        {"wave.height", replaced(wavy, "height = 0.04", "height = 0.05")},
        {"wave.length", replaced(wavy, "length = 1\n", "length = 0.9\n")},
        {"wave.period", replaced(with(wavy, "length = 1\n", "period = 0.8\n"), "period = 0.8", "period = 0.75")},
        {"wave.direction", set(wavy, "wave", "direction", "0", "\"180 deg\"")},
        {"wave.theory", set(wavy, "wave", "theory", "\"linear\"", "\"stream_function\"")},
        {"wave.empty_twin", set(wavy, "wave", "empty_twin", "\"auto\"", "\"off\"")},
        {"wave.calm_twin", set(wavy, "wave", "calm_twin", "\"auto\"", "\"off\"")},
        {"wave.spectrum", {random, with(with(random, "peakedness = 3.3\n", ""), "jonswap", "pierson-moskowitz")}},
        {"wave.significant_height", replaced(random, "height = 0.06", "height = 0.065")},
        {"wave.peak_period", replaced(random, "peak_period = 1", "peak_period = 0.98")},
        {"wave.peakedness", replaced(random, "peakedness = 3.3", "peakedness = 2")},
        {"wave.components", replaced(random, "components = 60", "components = 40")},
        {"wave.seed", replaced(random, "seed = 1", "seed = 2")},
        {"wave.second_height", replaced(two_waves, "second_height = 0.03", "second_height = 0.02")},
        {"wave.second_period", replaced(two_waves, "second_period = 0.8", "second_period = 0.85")},
        {"wave.crest", replaced(focused, "crest = 0.06", "crest = 0.05")},
        {"wave.focus_place", replaced(focused, "focus_place = 0.5", "focus_place = 0.6")},
        {"wave.focus_time", replaced(focused, "focus_time = 5", "focus_time = 5.5")},
        {"domain.downstream", set(sluice, "domain", "downstream", "0.061", "0.06")},
        {"sph.zones",
         set(with(fixed, "[sph]\n", "[sph]\nlevels = 1\n") + zoned, "sph", "zones", "\"fine\"", "\"coarse\"")},
        {"tank.absorbing", set(tank + zoned, "tank", "absorbing", "\"x\"", "\"y_max\"")},
        {"tank.wave_length", set(tank + zoned, "tank", "wave_length", "0.1", "0.2")},
        {"sph.air_c0", set(airy, "sph", "air_c0", "343", "100")},
        {"water.atmospheric_pressure", set(cavitating, "water", "atmospheric_pressure", "1e5", "2e5")},
        {"water.vapour_pressure", set(cavitating, "water", "vapour_pressure", "1e3", "2e3")},
        {"fvm.openfoam", set(fixed, "fvm", "openfoam", "\"/a\"", "\"/b\"")},
        {"fvm.correctors", set(fixed, "fvm", "correctors", "3", "4")},
        {"fvm.body_mesh", set(fixed, "fvm", "body_mesh", "\"auto\"", "\"whole\"")},
        {"run.threads", set(fixed, "run", "threads", "1", "2")},
        {"run.ranks", set(fixed, "run", "ranks", "2", "3")},
        {"run.stop", set(fixed, "run", "stop", "\"settled\"", "\"duration\"")},
        {"run.device", set(fixed, "run", "device", "\"cpu\"", "\"auto\"")},
    };
    for (const char* key : {"density", "viscosity", "surface_tension", "gravity", "air_density", "air_viscosity"})
        all[std::string("water.") + key] = set(fixed, "water", key, "1.5e-1", "1e-1");
    all["water.density"] = set(fixed, "water", "density", "1000", "1001");
    for (const char* key : {"checkpoint"}) all[std::string("run.") + key] = set(fixed, "run", key, "0.1", "0.2");
    for (const char* key : {"snapshots", "raster_spacing"})
        all[std::string("sampling.") + key] = set(fixed, "sampling", key, "0.1", "0.2");
    for (const char* key : {"delta", "alpha", "cfl"})
        all[std::string("sph.") + key] = set(fixed, "sph", key, "0.1", "0.2");
    all["sph.h_over_dp"] = set(fixed, "sph", "h_over_dp", "1.5", "2");
    all["sph.gamma"] = set(fixed, "sph", "gamma", "7", "4");
    all["sph.touch_support"] = set(fixed, "sph", "touch_support", "0.9", "0.95");
    all["fvm.interface"] = set(fixed, "fvm", "interface", "\"mules\"", "\"isoadvector\"");
    for (const char* key : {"max_courant", "max_alpha_courant", "interface_compression"})
        all[std::string("fvm.") + key] = set(fixed, "fvm", key, "1", "2");
    return all;
}

}  // namespace tw::test

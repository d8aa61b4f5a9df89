#include <CLI/CLI.hpp>

#include "app/command_options.h"

namespace tw::app {
namespace {

void add_surface(CLI::App& c, HullCommand& hull) {
    c.add_option("in", hull.in, "STL, OBJ, PLY, VTP, STEP or IGES, also compressed (.gz)")->required();
    add_unit_and_axes(c, hull.unit, hull.axes);
}

}  // namespace

void hull_info_options(CLI::App& c, HullCommand& hull) {
    hull.action = "info";
    add_surface(c, hull);
    c.add_option("--particle-spacing", hull.particle_spacing,
                 "also find walls too thin for particles of this spacing [m]");
}

void hull_repair_options(CLI::App& c, HullCommand& hull) {
    hull.action = "repair";
    add_surface(c, hull);
    c.add_option("out", hull.out, "STL to write")->required();
}

void hull_convert_options(CLI::App& c, HullCommand& hull) {
    hull.action = "convert";
    add_surface(c, hull);
    c.add_option("out", hull.out, "STL to write")->required();
}

void hull_make_options(CLI::App& c, HullCommand& hull) {
    hull.action = "make";
    CLI::Option* shape =
        c.add_option("shape", hull.shape, "one of the shapes that the list without a shape names")->type_name("SHAPE");
    c.add_option("-o,--out", hull.out, "STL to write")->needs(shape);
    c.add_option("parameters", hull.parameters, "name=value, e.g. length=4 \"beam=100 cm\" deadrise=20deg");
}

}  // namespace tw::app

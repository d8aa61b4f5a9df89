#include "scene/reference.h"

#include "app/arguments/output.h"
#include "base/atomic_file.h"
#include "meshes/generate.h"
#include "scene/effects/registry.h"

namespace tw::app {
namespace {

std::string names_text(const std::string& of) {
    std::string text;
    if (of == "effects")
        for (const std::string& name : effect_names()) text += name + "\n";
    else
        for (const HullShape& shape : hull_shapes()) text += shape.name + "\n";
    return text;
}

}  // namespace

int run_reference(const ReferenceCommand& command, const Common& common) {
    const std::string text = command.names.empty() ? scene_reference() : names_text(command.names);
    if (command.out.empty())
        say(common, text);
    else
        write_text_atomically(command.out, text);
    return done;
}

}  // namespace tw::app

#pragma once
#include <string>

#include "app/commands.h"

namespace tw::app {

/// Prints `text` unless quiet, or unless standard output is taken by --json -.
void say(const Common& common, const std::string& text);
/// Writes the facts where --json asks for them; nothing without --json.
void write_json(const Common& common, const std::string& json);

}  // namespace tw::app

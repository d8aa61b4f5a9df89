#pragma once
#include <filesystem>
#include <vector>

#include "spray/droplet.h"

namespace tw::spray {

/// Droplets from a table with the columns that `twinwake spray` writes. Throws InputError naming the line.
std::vector<Droplet> read_droplets(const std::filesystem::path& file);

}  // namespace tw::spray

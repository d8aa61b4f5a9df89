#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "text/document.h"

namespace tw {

// Numbers of a scene that are known within an interval only, and scenes in which numbers are others than their file says.
//
// A number is named as its key: SECTION.KEY, of a repeated section SECTION.NAME.KEY, or SECTION.N.KEY for the N-th, and an
// entry of a list has its place behind it; N and places begin with 1. "hull.draft", "body.rod.density", "tank.size.3".

/// By name, in SI.
using ChangedNumbers = std::map<std::string, double>;
/// The scene with these numbers in place of its own, and all that follows from them. Throws InputError.
Scene read_scene(const std::filesystem::path& file, const SceneOverrides& overrides, const ChangedNumbers& changed);

/// A number that is known within an interval.
struct UncertainNumber {
    std::string name;
    double value = 0, half_width = 0;  ///< of its 95 % interval [SI]
    std::string width;                 ///< the half width as it was written: "1 mm"
};

/// A section [uncertain] as it was written, in the scene or elsewhere: name = half width, a size or per cent of the number.
struct UncertainTable {
    std::filesystem::path file;
    TextValue table;
};
/// The numbers of a scene that its section [uncertain] names, and then those of `more`, which take precedence. Throws
/// InputError at the place in which a number is named: the scene has none of this name, it is no number, or says how the
/// scene is solved and not what it is; the half width is no positive one of its unit.
std::vector<UncertainNumber> uncertain_numbers(const std::filesystem::path& scene, const SceneOverrides& overrides,
                                               const UncertainTable* more = nullptr);

}  // namespace tw

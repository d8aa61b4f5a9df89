#pragma once
#include <string>

namespace tw {

/// How people call the forces: on a hull in a stream lift and drag; in a tank, where nothing flows past, by their
/// directions.
struct ForceNames {
    std::string up, along, friction, moment;
};
ForceNames force_names(bool stream);
/// "drag" of "Drag", for the middle of a sentence.
std::string lower_case_first(std::string text);

}  // namespace tw

#include "record/force_names.h"

namespace tw {

ForceNames force_names(bool stream) {
    return stream ? ForceNames{"Lift", "Drag", "Friction drag", "Trim moment"}
                  : ForceNames{"Force up", "Force along x", "Friction along x", "Moment about y"};
}

std::string lower_case_first(std::string text) {
    if (!text.empty() && text[0] >= 'A' && text[0] <= 'Z') text[0] = static_cast<char>(text[0] - 'A' + 'a');
    return text;
}

}  // namespace tw

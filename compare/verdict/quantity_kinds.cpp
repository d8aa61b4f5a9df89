#include "compare/verdict/quantity_kinds.h"

#include <algorithm>
#include <string_view>

namespace tw {

std::vector<std::string> kinds_of(std::string quantity) {
    const std::string name = quantity.substr(0, quantity.find(':'));
    const auto is = [&](auto... names) { return ((name == names) || ...); };
    if (is("drag", "total_drag", "added_resistance")) return {"drag"};
    if (is("lift", "trim_moment")) return {"lift"};
    if (name.starts_with("load_"))  // of what stands in a tank: its axis is the last letter
        return {name.starts_with("load_peak") ? "peak" : "impulse", name.ends_with("_x") ? "drag" : "lift"};
    if (is("pressure_arrival", "height_arrival", "body_arrival", "focused_crest_time")) return {"arrival"};
    if (is("pressure_mean")) return {quantity.replace(0, name.size(), "pressure"), "pressure"};  // of this gauge first
    if (is("pressure", "pressure_peak", "pressure_p99", "body_peak", "strain_peak")) return {"peak"};
    if (is("height", "height_peak", "height_p99", "wave_height", "wave_without", "wave_crest", "wave_trough",
           "significant_height", "crossing_height", "first_wave", "second_wave", "focused_crest", "run_up"))
        return {"height"};
    if (is("height_mean")) return {"level"};
    if (is("body_impulse")) return {"impulse"};
    if (is("body_depth", "body_speed", "body_turn", "heave_response", "pitch_response", "heave_over_wave",
           "pitch_over_wave", "added_trim", "added_rise"))
        return {"motion"};
    if (name.starts_with("peak_")) {  // in waves: peak_median:height:H1
        const std::string of = quantity.substr(name.size() + 1);
        return {of.starts_with("height") || of.starts_with("run_up") ? "height" : "peak"};
    }
    if (is("acceleration_centre", "acceleration_bow")) return {"peak"};
    return name.starts_with("splash") || name.starts_with("airborne") ? std::vector<std::string>{"splash"}
                                                                      : std::vector<std::string>{};
}

int main_rank(const std::string& name) {
    static constexpr std::string_view main[] = {"total_drag",
                                                "drag",
                                                "lift",
                                                "trim_moment",
                                                "running_trim",
                                                "rise",
                                                "body_depth",
                                                "body_speed",
                                                "body_peak",
                                                "load_impulse_x",
                                                "load_impulse_z",
                                                "load_peak_x",
                                                "load_peak_z",
                                                "strain_peak",
                                                "heave_over_wave",
                                                "pitch_over_wave",
                                                "heave_response",
                                                "pitch_response",
                                                "added_resistance",
                                                "acceleration_bow",
                                                "acceleration_centre",
                                                "run_up",
                                                "overtopping",
                                                "volume_gain",
                                                "volume_rate",
                                                "wave_transmission",
                                                "wave_height",
                                                "significant_height",
                                                "focused_crest",
                                                "first_wave",
                                                "splash_raised",
                                                "splash_sheet_height"};
    const auto* found = std::ranges::find(main, std::string_view(name).substr(0, name.find(':')));
    return found == std::end(main) ? -1 : static_cast<int>(found - std::begin(main));
}

}  // namespace tw

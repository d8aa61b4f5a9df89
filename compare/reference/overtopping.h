#pragma once
#include <optional>

namespace tw {

/// Mean overtopping of a smooth wall, from vertical to a slope of 1 in 2, by waves that do not break on it:
///
///   q / sqrt(g Hm0^3) = a exp(-(b Rc / Hm0)^1.3)
///   a = 0.09 - 0.01 (2 - cot)^2.1,   b = min(1.5 + 0.42 (2 - cot)^1.5, 2.35)
///
/// EurOtop 2018, eq. 5.18, of a vertical wall without foreshore eq. 7.1 (0.047, 2.35), mean values; standard deviations
/// 0.15 a and 0.1 b. Of irregular waves, whose highest bring most of the water.
struct Overtopping {
    double rate = 0;        ///< per metre of crest [m3/m/s]
    double half_width = 0;  ///< 1.96 standard deviations by those of a and b [m3/m/s]
    bool in_range = false;  ///< Rc / Hm0 below 3.5, and no impacts: h^2 / (Hm0 g T^2 / 2 pi) above 0.23
};

/// What meets the wall, and the wall.
struct WavesAtWall {
    double height = 0;     ///< Hm0 [m]
    double period = 0;     ///< Tm-1,0 [s]
    double depth = 0;      ///< of the water before it [m]
    double freeboard = 0;  ///< Rc, above still water [m]
    double cot_slope = 0;  ///< cotangent of its face [-]
    double gravity = 0;    ///< [m/s2]
};
/// Nothing for a gentler slope than 1 in 2, where it matters whether the waves break on it.
std::optional<Overtopping> eurotop_overtopping(const WavesAtWall& of);

}  // namespace tw

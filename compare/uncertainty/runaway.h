#pragma once
#include <span>
#include <string>

#include "compare/uncertainty/eca_hoekstra.h"
#include "compare/uncertainty/study_level.h"

namespace tw {

/// Why the values run away as the spacing shrinks, and have no limit that could be estimated; empty where they do not,
/// and where they are equal within their own noise and rounding (equal_within_noise in study_level.h).
/// - three levels: they change to one side, and per factor in h the finest pair by twice as much as the coarser one or
///   more: eps21/ln r21 >= 2 eps32/ln r32, the growth of 1/h between h and 2 h. (Three values of pure noise do that in
///   one trial of ten; with the ITTC's R >= 1 it is one of six.) Where the values have noise of their own, as time means
///   do, the excess has to lie beyond its 95 % interval.
/// - more: the free fit of Eca & Hoekstra has p <= 0, and phi = c + b ln h, the border of divergence, has a slope
///   beyond its 95 % interval, t = |b|/s_b > t_95(n - 2); without that test one family of seven that only scatters
///   would be refused.
/// `eca` of the same levels, which are as from finest_first.
std::string why_running_away(std::span<const StudyLevel> levels, const EcaHoekstra& eca);

}  // namespace tw

#pragma once

namespace tw {

/// Tension control (Sun et al. 2018, doi:10.1016/j.cpc.2017.11.016): inside the fluid (Shepard sum above a limit)
/// p_j - p_i in place of p_j + p_i where p_i < 0, so that what is stretched does not clump. Not beside walls, where the
/// pair forces are the load. This is what stands for p_i.
inline float tension_controlled(float p_i, float support, float from) { return support > from && p_i < 0 ? -p_i : p_i; }

}  // namespace tw

#include "foam_cases/files/times_of_table.h"

#include <algorithm>
#include <cmath>

namespace tw {

std::vector<double> times_of_table(const MotionLaw& law, double duration, double longest_step) {
    double shortest = duration / 100;
    if (law.kind == MotionLaw::Kind::sinusoid) shortest = std::min(shortest, law.period / 50);
    if (law.ramp > 0) shortest = std::min(shortest, law.ramp / 50);
    for (std::size_t i = 1; i < law.times.size(); ++i)
        shortest = std::min(shortest, (law.times[i] - law.times[i - 1]) / 10);
    const int rows = std::min(20000, static_cast<int>(std::ceil(duration / shortest)) + 1);
    const int behind = 1 + static_cast<int>(std::ceil(longest_step / duration * rows));
    std::vector<double> times;
    for (int i = -1; i <= rows + behind; ++i) times.push_back(duration * i / rows);
    return times;
}

}  // namespace tw

#pragma once
#include "foam_cases/case_plan.h"

namespace tw {

/// As foam_cases/forcing_zones/wave_numbers.H reads them.
Dictionary numbers_of(const WaveSum& wave);
Dictionary numbers_of(const WaveComponents& sea);

}  // namespace tw

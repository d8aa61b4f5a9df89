#pragma once
#include "compare/metrics/wave_peaks.h"
#include "record/run_record.h"

namespace tw::test {

/// What add_wave_peaks says of one record of interFoam.
inline Comparison compared(const RunRecord& record) {
    Comparison c;
    c.sources = {record};
    c.names = {"fvm"};
    add_wave_peaks(c);
    return c;
}

}  // namespace tw::test

#include "foam_cases/files/wave_numbers.h"

namespace tw {

Dictionary numbers_of(const WaveSum& wave) {
    List U, eta;
    for (int j = 0; j < wave.terms; ++j) U.push_back(wave.U[j]), eta.push_back(wave.eta[j]);
    Dictionary numbers{
        {"k", wave.k},         {"depth", wave.depth},     {"direction", wave.direction}, {"speed", wave.speed},
        {"phase", wave.phase}, {"current", wave.current}, {"crest", wave.crest},         {"U", U},
        {"eta", eta}};
    if (wave.across != 0) numbers.add("across", wave.across);
    return numbers;
}

Dictionary numbers_of(const WaveComponents& sea) {
    List k, omega, amplitude, phase;
    for (int n = 0; n < sea.count; ++n)
        k.push_back(sea.k[n]), omega.push_back(sea.omega[n]), amplitude.push_back(sea.height[n]),
            phase.push_back(sea.phase[n]);
    Dictionary numbers{{"depth", sea.depth}, {"direction", sea.direction}, {"current", sea.current}, {"k", k},
                       {"omega", omega},     {"amplitude", amplitude},     {"phase", phase}};
    if (sea.stream != 0) numbers.add("stream", sea.stream);
    return numbers;
}

}  // namespace tw

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

}  // namespace tw

#include "foam_cases/files/case_files.h"

namespace tw {
namespace {

/// As forcing_zones.C reads it.
Dictionary numbers_of(const WaveSum& wave) {
    List U, eta;
    for (int j = 0; j < wave.terms; ++j) U.push_back(wave.U[j]), eta.push_back(wave.eta[j]);
    return {{"k", wave.k},         {"depth", wave.depth},     {"direction", wave.direction}, {"speed", wave.speed},
            {"phase", wave.phase}, {"current", wave.current}, {"crest", wave.crest},         {"U", U},
            {"eta", eta}};
}

}  // namespace

std::string forcing_zones_file(const Flavour& flavour, const ZoneSource& source) {
    Dictionary sources;
    add_zones(source, sources);
    return foam_file("dictionary", flavour.sources_file(), sources);
}

void add_zones(const ZoneSource& source, Dictionary& sources) {
    if (source.zones.empty()) return;
    List zones;
    for (const ForcingZone& zone : source.zones) {
        Dictionary d{{"axis", zone.axis}, {"begin", zone.begin}, {"end", zone.end}, {"strength", zone.gamma}};
        if (zone.makes_wave) d.add("makesWave", true);
        zones.push_back(d);
    }
    Dictionary all{{"type", Word("forcingZones")}, {"velocity", source.velocity}, {"zones", zones}};
    if (source.wave) all.add("wave", numbers_of(*source.wave));
    sources.add("forcingZones", all);
}

std::vector<CaseFile> forcing_zones_files(const CasePlan& plan) {
    if (plan.zones.zones.empty() || plan.scene->tank_motion) return {};  // then they stand beside the tank's motion
    return {{"constant/" + plan.flavour.sources_file(), forcing_zones_file(plan.flavour, plan.zones)}};
}

}  // namespace tw

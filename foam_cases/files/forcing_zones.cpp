#include <map>

#include "foam_cases/files/case_files.h"
#include "foam_cases/files/wave_numbers.h"

namespace tw {
namespace {

bool is_oblique(const ZoneSource& source) { return source.wave && source.wave->across != 0; }

/// Zones know water at rest: they take frequencies as they are met, and heights that make with them the velocities that
/// the waves have in their water.
WaveComponents at_rest(WaveComponents sea) {
    for (int n = 0; n < sea.count; ++n) {
        const double met = sea.omega[n] + sea.direction * sea.k[n] * sea.stream;
        sea.height[n] *= sea.omega[n] / met;
        sea.omega[n] = met;
    }
    sea.stream = 0;
    return sea;
}

}  // namespace

std::string forcing_zones_file(const Flavour& flavour, const ZoneSource& source) {
    Dictionary sources;
    add_zones(source, sources);
    return foam_file("dictionary", flavour.sources_file(), sources);
}

void add_zones(const ZoneSource& source, Dictionary& sources) {
    // one source for each velocity to which zones draw: that of the stream, and of water of another depth behind
    std::map<double, List> of_share;
    for (const ForcingZone& zone : source.zones) {
        Dictionary d{{"axis", zone.axis}, {"begin", zone.begin}, {"end", zone.end}, {"strength", zone.gamma}};
        if (zone.makes_wave) d.add("makesWave", true);
        of_share[zone.share].push_back(d);
    }
    for (const auto& [share, zones] : of_share) {
        Dictionary all{{"type", Word(source.sea           ? "forcingZonesOfASea"
                                     : is_oblique(source) ? "forcingZonesOblique"
                                                          : "forcingZones")},
                       {"velocity", Vec3(share * source.velocity)},
                       {"zones", zones}};
        if (source.wave) all.add("wave", numbers_of(*source.wave));
        if (source.sea) all.add("sea", numbers_of(at_rest(*source.sea)));
        sources.add(share == 1 ? "forcingZones" : "forcingZonesBehind", all);
    }
}

std::vector<CaseFile> forcing_zones_files(const CasePlan& plan) {
    if (plan.zones.zones.empty() || plan.scene->tank_motion) return {};  // then they stand beside the tank's motion
    return {{"constant/" + plan.flavour.sources_file(), forcing_zones_file(plan.flavour, plan.zones)}};
}

}  // namespace tw

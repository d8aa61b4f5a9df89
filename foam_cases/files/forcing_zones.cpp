#include "foam_cases/files/case_files.h"

namespace tw {

std::string forcing_zones_file(const Flavour& flavour, const ZoneSource& source) {
    Dictionary sources;
    add_zones(source, sources);
    return foam_file("dictionary", flavour.sources_file(), sources);
}

void add_zones(const ZoneSource& source, Dictionary& sources) {
    if (source.zones.empty()) return;
    List zones;
    for (const ForcingZone& zone : source.zones)
        zones.push_back(
            Dictionary{{"axis", zone.axis}, {"begin", zone.begin}, {"end", zone.end}, {"strength", zone.gamma}});
    sources.add("forcingZones",
                Dictionary{{"type", Word("forcingZones")}, {"velocity", source.velocity}, {"zones", zones}});
}

std::vector<CaseFile> forcing_zones_files(const CasePlan& plan) {
    if (plan.zones.zones.empty() || plan.scene->tank_motion) return {};  // then they stand beside the tank's motion
    return {{"constant/" + plan.flavour.sources_file(), forcing_zones_file(plan.flavour, plan.zones)}};
}

}  // namespace tw

#include "foam_cases/files/case_files.h"
#include "foam_cases/files/wave_numbers.h"

namespace tw {

std::string inlet_wave_type(const CasePlan& plan, const std::string& of_regular) {
    if (!plan.inlet_wave) return "fixedValue";
    return of_regular + (plan.scene->sea ? "OfASea" : "");
}

std::vector<CaseFile> inlet_wave_files(const CasePlan& plan) {
    if (!plan.inlet_wave) return {};
    const Scene& scene = *plan.scene;
    Dictionary d{{"velocity", Vec3(scene.motion.speed, 0, 0)},
                 {"begin", plan.inlet_wave->begin},
                 {"ramp", plan.inlet_wave->ramp}};
    if (scene.wave)
        d.add("wave", numbers_of(scene.wave->sum));
    else
        d.add("sea", numbers_of(scene.sea->waves));
    return {{"constant/inletWave", foam_file("dictionary", "inletWave", d)}};
}

}  // namespace tw

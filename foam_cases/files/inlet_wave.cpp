#include "foam_cases/files/case_files.h"
#include "foam_cases/files/wave_numbers.h"

namespace tw {

std::vector<CaseFile> inlet_wave_files(const CasePlan& plan) {
    if (!plan.inlet_wave) return {};
    const Scene& scene = *plan.scene;
    const Dictionary d{{"velocity", Vec3(scene.motion.speed, 0, 0)},
                       {"begin", plan.inlet_wave->begin},
                       {"ramp", plan.inlet_wave->ramp},
                       {"wave", numbers_of(scene.wave->sum)}};
    return {{"constant/inletWave", foam_file("dictionary", "inletWave", d)}};
}

}  // namespace tw

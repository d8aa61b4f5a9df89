#include "sph_solver/effects/cavitation.h"

#include <algorithm>

#include "sph_solver/domain/level_setup.h"

namespace tw {
namespace {

class CutOff : public Effect {
public:
    explicit CutOff(const Cavitation& options) : lowest_(static_cast<float>(options.lowest_pressure)) {}

    void change_pressure(const StepView& step) override {
#pragma omp parallel for schedule(static)
        for (std::size_t i = 0; i < step.count(); ++i) step.pass.stress[i].p = std::max(step.pass.stress[i].p, lowest_);
    }

private:
    float lowest_;
};

}  // namespace

std::unique_ptr<Effect> make_cavitation(const Cavitation& options) { return std::make_unique<CutOff>(options); }

}  // namespace tw

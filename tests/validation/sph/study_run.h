#pragma once
#include <optional>
#include <string>

#include "record/run_record.h"
#include "scene/scene.h"

namespace tw::test {

/// A study's scene, run by the SPH solver in a folder of its own, and the record it left on disk.
struct StudyRun {
    Scene scene;
    RunRecord record;
};
/// `study`: name of a file in studies/, without .toml; `duration` [s] in place of the study's own; `scale`
/// multiplies its sizes of particles.
StudyRun run_study(const std::string& study, std::optional<double> duration = {}, double scale = 1);

}  // namespace tw::test

#include "study_run.h"

#include <unistd.h>

#include "sph_solver/run_sph.h"
#include "test_paths.h"

namespace tw::test {

StudyRun run_study(const std::string& study, std::optional<double> duration, double scale) {
    StudyRun run;
    SceneOverrides overrides;
    overrides.duration = duration;
    if (scale != 1) overrides.scale_resolution = scale;
    run.scene = read_scene(std::filesystem::path(TWINWAKE_SOURCE) / "studies" / (study + ".toml"), overrides);
    RunOptions options;
    options.folder = std::filesystem::temp_directory_path() / ("twinwake_" + std::to_string(getpid()) + "_" + study);
    run_sph(run.scene, options);
    run.record = read_record(options.folder / "record.h5");
    std::filesystem::remove_all(options.folder);
    return run;
}

}  // namespace tw::test

#pragma once
#include <string>

#include "record/run_record.h"
#include "scene/scene.h"

namespace tw::app {

/// Where each body that moves is at the end of a run, how fast, how far it has turned, its largest force: a line each
std::string outcome_of_bodies(const Scene& scene, const RunRecord& record);

}  // namespace tw::app

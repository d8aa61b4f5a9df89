#pragma once

namespace tw::app {

// What stands below the options in the help of a subcommand.
extern const char* const about_uncertainty;
extern const char* const about_import;
extern const char* const about_ablate;
extern const char* const about_openfoam;
extern const char* const about_setup_openfoam;

}  // namespace tw::app

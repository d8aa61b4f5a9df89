#pragma once
#include "app/arguments/commands.h"

namespace tw::app {

struct ValidateCommand {
    std::filesystem::path suite;     ///< its folder, or the validation.json of an earlier report
    std::string tier = "minutes";    ///< the dearest that is run
    std::string method;              ///< sph, fvm, both; empty: what the cases and their scenes say
    std::vector<std::string> cases;  ///< names; empty: all
    std::filesystem::path out;       ///< empty: runs/<name of the suite's folder>_validation
    std::filesystem::path against;   ///< an earlier validation.json; empty: none
    std::filesystem::path keep;      ///< an earlier validation.json for what is not run; empty: none
    std::filesystem::path pages;     ///< folder for Markdown pages; empty: none
    std::vector<std::filesystem::path> into;  ///< Markdown pages of which the tables are made anew
    std::string estimator;           ///< one of uncertainty_methods(); empty: as the report has it
    std::string require;             ///< goals, no-worse; empty: nothing
    bool formulas = false;           ///< only lists the formulas
    bool overwrite = false;
    int threads = 0;
    Making making;
};
/// Gives the exit status. Throws InputError: no suite, a case that it does not have, `require` without `against`.
int run_validate(const ValidateCommand& command, const Common& common);

}  // namespace tw::app

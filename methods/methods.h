#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace tw {

/// What is said of a method of solution wherever its name stands: in scenes, folders, records, tables and the report.
struct Method {
    std::string name;      ///< in scenes, records, folders and files: "sph"
    std::string label;     ///< in sentences: "SPH"
    std::string elements;  ///< what its solution is made of: "particles"
};

/// The methods that twinwake runs, in the order of tables. Records of any other name are imports.
const std::vector<Method>& methods();
std::vector<std::string> method_names();
/// Null: none of twinwake's own.
const Method* find_method(const std::string& name);
/// Throws InputError with the names that are known.
const Method& method_named(const std::string& name);

/// Place in the order of tables; all others stand behind.
std::size_t method_rank(const std::string& name);
/// "SPH" of "sph", "SPH 2" of "sph 2"; others as they are.
std::string method_label(const std::string& name);
/// "particles"; "elements" of others.
std::string elements_of(const std::string& name);
/// "particles or cells": of all methods.
std::string elements_of_all();

}  // namespace tw

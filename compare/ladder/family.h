#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "record/run_record.h"

namespace tw {

/// What a run was made with besides its resolution. Runs of one family differ in resolution alone.
struct Family {
    std::string hash;      ///< the record's attribute family_hash; empty in imports and in older records
    std::string likeness;  ///< hull and main numbers as text: what stands in for the hash where there is none
    std::map<std::string, std::string> settings;  ///< attributes and effects ("effect shifting": "on")
    std::map<std::string, double> numbers;        ///< as solved; none that follow from resolution or machine
};
Family family_of(const RunRecord& record);

/// "delta is 0.1 and 0.2, effect shifting is on and off": what the records show of it.
std::string family_differences(const Family& a, const Family& b);

/// Whether the records show nothing but resolution, domain and duration to differ.
bool same_settings(const Family& a, const Family& b);

/// A choice that should not matter, made otherwise: the share of the error that it leaves in the ladder's value is
/// `factor` |value - varied value|, with 1/(1 - 1/r^q) for a choice made finer by r whose error falls with order q.
struct Varied {
    std::string name;  ///< "sound speed x 1.5"
    double factor = 1;
    double steps = 1;  ///< how many times as many time steps it is to take; 1: they are not what it changes
};
/// `varied` against `base`, where they differ in nothing but the sound speed, a time step made shorter, or a surface
/// captured geometrically, another model whose change counts in full.
std::optional<Varied> variation_between(const Family& base, const Family& varied);

}  // namespace tw

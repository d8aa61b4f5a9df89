#pragma once
#include <functional>
#include <string>

namespace tw {

/// What a trial may take beyond what the process has already.
struct TrialLimits {
    double seconds = 60;    ///< by the clock [s]
    double processor = 60;  ///< [s] of its own, so that a busy machine takes none of it away
    double bytes = 4e9;     ///< of memory [bytes]
};

/// What `work` answers, done in a child process, where a crash, an endless loop or the end of memory in a library harms
/// nobody. What it prints is lost, and what it changes stays there. For readers of others that trust their files.
/// Throws InputError that says why it did not come to its end: its own words, or what became of the child.
std::string answer_of_trial(const std::function<std::string()>& work, const TrialLimits& limits = {});

}  // namespace tw

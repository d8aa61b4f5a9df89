#pragma once
#include <string>

namespace tw {

std::string cpu_model();        ///< e.g. "Intel(R) Xeon(R) ... x 2 threads"
std::string instruction_set();  ///< best level this processor has: "x86-64", "x86-64-v2", "x86-64-v3", "x86-64-v4"
std::string host_name();
/// Memory this process may use [bytes]: the machine's, or less where a control group says so.
double machine_memory();
/// Processor time that all programs of this machine have had since it began [s]; NaN where the system does not say.
double processor_time_of_all();
/// What all its processors together give in a second [s].
double processors_online();
std::string utc_now();  ///< "2024-01-31T12:34:56Z"

}  // namespace tw

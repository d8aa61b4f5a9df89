#pragma once
#include <random>
#include <string>
#include <vector>

namespace tw::readers {

/// One of the seeds with one to eight changes: bits, bytes, numbers replaced by extremes (as text and as bytes), lines and
/// blocks taken out, doubled and moved, a part of another seed put in, its end cut off. At most 64 KiB longer than the
/// seed. The same for the same state of `random`, on every machine.
std::string mutated(const std::vector<std::string>& seeds, std::mt19937_64& random);

}  // namespace tw::readers

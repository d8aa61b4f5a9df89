#pragma once
#include <stdexcept>
#include <string>

namespace tw {

/// The user's input or the machine's set-up is at fault: nothing was run or written. Exit status 2.
/// The message names the file (line:column), what was found, what was expected and what to do.
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A run failed after it had begun; its state was saved. Exit status 3.
struct RunError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace tw

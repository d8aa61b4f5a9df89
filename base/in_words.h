#pragma once
#include <exception>
#include <string>

namespace tw {

/// What an exception says, for people: of the file system the place and the system's reason, of memory that there was
/// not enough, of a library's others their words without its own name for them. The one place where exceptions that are
/// not ours become messages.
std::string in_words(const std::exception& e);

}  // namespace tw

#pragma once
#include "scene/uncertain.h"

namespace tw {

/// Puts numbers into a document as if they stood in the file. Throws InputError: it has none of this name.
void change_numbers(TextValue& document, const ChangedNumbers& changed, const std::filesystem::path& file);

/// The numbers of `document` that the section [uncertain] of `of` names. Throws InputError.
std::vector<UncertainNumber> uncertain_numbers_of(const UncertainTable& of, const TextValue& document);

}  // namespace tw

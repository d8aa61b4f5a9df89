#pragma once
#include <string>

namespace tw {

/// An effect's influence (record/effect_choice.h) as people read it. It is kept as "drag: ...; lift: ...; splash: ...";
/// where nothing streams past, drag and lift are the forces along x and up.
std::string influence_in_words(std::string influence, bool stream);

}  // namespace tw

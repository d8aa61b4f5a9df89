#pragma once
#include <string>
#include <vector>

#include "record/effect_choice.h"

namespace tw {

/// An effect's influence (record/effect_choice.h) as people read it. It is kept as "drag: ...; lift: ...; splash: ...";
/// where nothing streams past, drag and lift are the forces along x and up.
std::string influence_in_words(std::string influence, bool stream);

/// One bound as people read it: "arrival: up to 14 % more (measured ...)", "pressure: 35 % less to 43 % more", "±1 %".
std::string in_words(const EffectBound& bound);
/// Those of an effect, each source once: kinds of which one says the same are named together.
std::vector<std::string> bounds_in_words(const std::vector<EffectBound>& bounds);

}  // namespace tw

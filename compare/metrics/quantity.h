#pragma once
#include <string>
#include <utility>

#include "compare/compare.h"

namespace tw {

/// Why a value is missing where nothing went wrong.
inline constexpr const char* not_given = "this method does not give it";

inline Quantity new_quantity(std::string name, std::string label, std::string unit, std::string definition) {
    Quantity q;
    q.name = std::move(name);
    q.label = std::move(label);
    q.unit = std::move(unit);
    q.definition = std::move(definition);
    return q;
}

}  // namespace tw

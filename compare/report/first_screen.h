#pragma once
#include <string>

#include "compare/compare.h"
#include "compare/report/figures.h"

namespace tw {

/// What a page shows before anybody scrolls (1400 x 900): hull and conditions; per main quantity the sentence and a
/// strip with the values; the pictures side by side; what speaks against it; what to do next.
std::string first_screen(const Comparison& comparison, const Figures& figures);

}  // namespace tw

#pragma once
#include <string>

namespace tw {

/// A number as people write it: so many significant digits, no powers of ten from 1e-6 to 1e9: "21300", "0.00031", "4".
std::string plain_number(double value, int digits = 3);

}  // namespace tw

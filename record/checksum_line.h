#pragma once
#include <string>
#include <string_view>

namespace tw {

// Our HDF5 files end in a line behind HDF5's own bytes, where HDF5 does not look: "twinwake sha256 " and 64 hexadecimal
// digits. The Fletcher-32 sums inside name the array that is damaged, but take FF FF for 00 00.

enum class Bytes { whole, not_signed, changed };

std::string with_checksum_line(std::string bytes);
/// What the line says of the bytes before it. not_signed: there is none, the file is cut off or another program's.
Bytes judge_bytes(std::string_view content);

}  // namespace tw

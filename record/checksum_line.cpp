#include "record/checksum_line.h"

#include "base/sha256.h"

namespace tw {
namespace {

constexpr std::string_view label = "\ntwinwake sha256 ";
constexpr std::size_t digits = 64, length = label.size() + digits + 1;

}  // namespace

std::string with_checksum_line(std::string bytes) {
    const std::string sum = sha256_hex(bytes);
    return bytes.append(label).append(sum).append("\n");
}

Bytes judge_bytes(std::string_view content) {
    if (content.size() < length) return Bytes::not_signed;
    const std::string_view body = content.substr(0, content.size() - length), line = content.substr(body.size());
    if (!line.starts_with(label)) return Bytes::not_signed;
    return sha256_hex(body) == line.substr(label.size(), digits) ? Bytes::whole : Bytes::changed;
}

}  // namespace tw

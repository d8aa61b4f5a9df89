#include "compare/report/script_source.h"

#include "base/sha256.h"
#include "compare/report/base64.h"

namespace tw {

std::string script_source(const std::string& script) {
    const std::string hex = sha256_hex(script);
    std::string digest;
    for (std::size_t k = 0; k < hex.size(); k += 2)
        digest += static_cast<char>(std::stoi(hex.substr(k, 2), nullptr, 16));
    return "'sha256-" + base64(digest) + "'";
}

}  // namespace tw

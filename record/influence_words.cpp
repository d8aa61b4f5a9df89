#include "record/influence_words.h"

#include <string_view>
#include <utility>

namespace tw {

std::string influence_in_words(std::string influence, bool stream) {
    if (stream) return influence;
    for (const auto& [kept, said] :
         {std::pair<std::string_view, std::string_view>{"drag: ", "force along x: "}, {"lift: ", "force up: "}})
        for (std::size_t at = influence.find(kept); at != influence.npos; at = influence.find(kept, at + said.size()))
            if (at == 0 || influence.compare(at - 2, 2, "; ") == 0) influence.replace(at, kept.size(), said);
    return influence;
}

}  // namespace tw

#include "record/influence_words.h"

#include <string_view>
#include <utility>

#include "record/force_names.h"

namespace tw {

std::string influence_in_words(std::string influence, bool stream) {
    if (stream) return influence;
    const ForceNames called = force_names(stream);
    for (const auto& [kept, force] :
         {std::pair<std::string_view, std::string>{"drag: ", called.along}, {"lift: ", called.up}}) {
        const std::string said = lower_case_first(force) + ": ";
        for (std::size_t at = influence.find(kept); at != influence.npos; at = influence.find(kept, at + said.size()))
            if (at == 0 || influence.compare(at - 2, 2, "; ") == 0) influence.replace(at, kept.size(), said);
    }
    return influence;
}

}  // namespace tw

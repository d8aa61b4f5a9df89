#include "app/terminal/command_words.h"

#include <filesystem>

namespace tw::app {

std::vector<std::string> without_options(const std::vector<std::string>& words,
                                         const std::map<std::string, int>& options) {
    std::vector<std::string> left;
    for (std::size_t k = 0; k < words.size(); ++k) {
        const std::string option = words[k].substr(0, words[k].find('='));
        const auto found = options.find(option);
        if (found == options.end())
            left.push_back(words[k]);
        else if (found->second > 0 && option == words[k])
            ++k;  // its value
    }
    return left;
}

std::string command_text(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : without_options(words, {{"--out", 1},
                                                           {"--json", 1},
                                                           {"--threads", 1},
                                                           {"--ranks", 1},
                                                           {"--jobs", 1},
                                                           {"--collect", 0},
                                                           {"--report-every", 1},
                                                           {"--resume", 0},
                                                           {"--overwrite", 0},
                                                           {"-q", 0},
                                                           {"--quiet", 0}}))
        text += (word.starts_with('/') ? std::filesystem::path(word).filename().string() : word) + "\n";
    return text;
}

}  // namespace tw::app

#include "text/did_you_mean.h"

#include <algorithm>
#include <numeric>

namespace tw {
namespace {

/// Number of single-letter insertions, deletions, replacements and swaps of neighbours from a to b.
std::size_t edits(const std::string& a, const std::string& b) {
    std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
    std::iota(d[0].begin(), d[0].end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        for (std::size_t j = 1; j <= b.size(); ++j) {
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
    }
    return d[a.size()][b.size()];
}

}  // namespace

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
    std::string best;
    std::size_t least = 1 + word.size() / 3;  // further away it is no misspelling but another word
    for (const std::string& k : known)
        if (edits(word, k) <= least && (best.empty() || edits(word, k) < edits(word, best))) best = k;
    return best.empty() ? "" : "; did you mean '" + best + "'?";
}

}  // namespace tw

#include "compare/metrics/box_walls.h"

#include "record/record_numbers.h"

namespace tw {

namespace {

std::string channel_of(const Comparison& c) { return text_of(c.sources.front(), "channel"); }

}  // namespace

bool in_a_channel(const Comparison& c) { return !channel_of(c).empty(); }

void add_box(Comparison& c) {
    if (in_a_channel(c)) c.banners.push_back("Values are those of a hull in " + channel_of(c) + ", not of open water.");
    c.walls = text_of(c.sources.front(), "box_walls");
}

std::vector<std::string> all_banners(const Comparison& c) {
    std::vector<std::string> banners = c.banners;
    if (!c.walls.empty()) banners.push_back("Values are those of this box, not of open water: " + c.walls + ".");
    banners.insert(banners.end(), c.tuned.begin(), c.tuned.end());
    return banners;
}

}  // namespace tw

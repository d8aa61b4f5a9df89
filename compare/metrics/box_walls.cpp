#include "compare/metrics/box_walls.h"

#include "record/record_numbers.h"

namespace tw {

namespace {

std::string channel_of(const Comparison& c) { return text_of(c.sources.front(), "channel"); }

std::string box_banner(const std::string& walls) {
    return "Values are those of this box, not of open water: " + walls + ".";
}

}  // namespace

bool in_a_channel(const Comparison& c) { return !channel_of(c).empty(); }

void say_of_the_box(Comparison& c, std::string walls) {
    std::erase(c.banners, box_banner(c.walls));
    c.walls = std::move(walls);
    if (!c.walls.empty()) c.banners.push_back(box_banner(c.walls));
}

void add_box(Comparison& c) {
    if (in_a_channel(c)) c.banners.push_back("Values are those of a hull in " + channel_of(c) + ", not of open water.");
    say_of_the_box(c, text_of(c.sources.front(), "box_walls"));
}

}  // namespace tw

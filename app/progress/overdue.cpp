#include "app/progress/overdue.h"

#include <fmt/format.h>

#include "compare/report/numbers.h"
#include "text/plain_number.h"

namespace tw::app {
namespace {

constexpr double first_minute = 60;  ///< of steps [s]: caches are warm, and the first small steps behind
constexpr double too_many = 3;       ///< times the prediction

}  // namespace

std::string Overdue::look(const Progress& p) {
    if (looked_ || !(predicted_ > 0) || !(p.steps > 0) || !(p.duration > 0)) return {};
    if (!start_) {
        start_ = Start{p.time, p.wall};
        return {};
    }
    const double wall = p.wall - start_->wall, share = (p.time - start_->time) / p.duration;
    if (wall < first_minute) return {};
    looked_ = true;
    if (!(share > 0)) return {};
    const double whole = wall / share;  // of the whole duration at this pace
    if (whole < too_many * predicted_) return {};
    return fmt::format(
        "at the pace of its first minute the whole run takes {}, {} times the predicted {}: other programs "
        "may use the processors, or its time steps are shorter than predicted. It can be stopped with "
        "Ctrl-C and continued with --resume; a larger near_hull makes it faster",
        time_text(whole), plain_number(whole / predicted_, 2), time_text(predicted_));
}

}  // namespace tw::app

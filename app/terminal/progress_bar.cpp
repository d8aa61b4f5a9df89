#include "app/terminal/progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "app/terminal/terminal.h"

namespace tw::app {
namespace {

std::string clock_text(double seconds) {
    const long s = std::lround(std::max(0.0, seconds));
    return s < 3600 ? fmt::format("{}:{:02}", s / 60, s % 60)
                    : fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

std::string left_text(double seconds) { return seconds > 0 ? fmt::format("{} left  ", clock_text(seconds)) : ""; }

}  // namespace

ProgressBar::ProgressBar(std::string label, bool quiet)
    : label_(std::move(label)), quiet_(quiet), terminal_(is_terminal(STDERR_FILENO)) {}

ProgressBar::~ProgressBar() {
    if (shown_ && terminal_) std::fputc('\n', stderr);
}

void ProgressBar::show(const Progress& p) {
    const double share = p.duration > 0 ? std::clamp(p.time / p.duration, 0.0, 1.0) : 0;
    // Phases before the time loop have no share: their note is news.
    if (!due(share, p.time == 0 && p.note != last_note_)) return;
    const std::string steps = p.steps > 0 ? fmt::format("step {}  ", p.steps) : "";
    draw(share, fmt::format("{:3.0f} %  {}t = {:.4g} of {:.4g} s  {}{} elapsed  {}", 100 * share, left_text(p.eta),
                            p.time, p.duration, steps, clock_text(p.wall), p.note));
    last_note_ = p.note;
}

void ProgressBar::show(double share, double wall, double left, const std::string& done, const std::string& note) {
    share = std::clamp(share, 0.0, 1.0);
    if (!due(share, false)) return;
    draw(share,
         fmt::format("{:3.0f} %  {}{}  {} elapsed  {}", 100 * share, left_text(left), done, clock_text(wall), note));
}

void ProgressBar::clear() const {
    if (shown_ && terminal_) std::fputs("\r\033[K", stderr);
}

bool ProgressBar::due(double share, bool phase) const {
    if (quiet_) return false;
    const double since = shown_ ? std::chrono::duration<double>(std::chrono::steady_clock::now() - last_).count() : 1e9;
    const bool now = terminal_ ? since > 0.2 : since > 30 && (share >= last_share_ + 0.1 || since > 120);
    return now || phase || (share >= 1 && last_share_ < 1);
}

void ProgressBar::draw(double share, const std::string& facts) {
    if (terminal_) {
        // A line that is wider than the terminal goes on in the next, and the next one could not be written over it.
        const std::size_t columns = terminal_columns(STDERR_FILENO), width = std::min<std::size_t>(24, columns / 6);
        const auto full = static_cast<std::size_t>(share * static_cast<double>(width));
        const std::string bar = std::string(full, '#') + std::string(width - full, '.');
        std::fputs(("\r\033[K" + fitted(fmt::format("{} [{}] {}", label_, bar, facts), columns)).c_str(), stderr);
    } else {
        std::fputs(fmt::format("{}: {}\n", label_, facts).c_str(), stderr);
    }
    std::fflush(stderr);
    shown_ = true;
    last_ = std::chrono::steady_clock::now();
    last_share_ = share;
}

}  // namespace tw::app

#include "app/terminal/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace tw::app {

bool is_terminal(int descriptor) {
    const char* const kind = std::getenv("TERM");
    return isatty(descriptor) != 0 && !(kind && std::string_view(kind) == "dumb");
}

std::size_t terminal_columns(int descriptor) {
    constexpr long usual = 80, narrowest = 20;
    winsize size{};
    if (ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col >= narrowest) return size.ws_col;
    const char* const said = std::getenv("COLUMNS");
    const long columns = said ? std::atol(said) : usual;
    return static_cast<std::size_t>(columns >= narrowest ? columns : usual);
}

std::string fitted(const std::string& line, std::size_t columns) {
    std::size_t shown = 0, cut = 0;
    for (std::size_t k = 0; k < line.size(); ++k) {
        if ((static_cast<unsigned char>(line[k]) & 0xC0) == 0x80) continue;  // goes on with a character
        if (shown + 4 == columns) cut = k;
        if (++shown >= columns) return line.substr(0, cut) + "...";
    }
    return line;
}

}  // namespace tw::app

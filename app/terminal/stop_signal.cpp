#include "app/terminal/stop_signal.h"

#include <csignal>

namespace tw::app {
namespace {
volatile std::sig_atomic_t asked = 0;
}

void catch_stop_signals() {
    struct sigaction action {};
    action.sa_handler = [](int) { asked = 1; };
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    for (const int signal : {SIGINT, SIGTERM, SIGUSR1}) sigaction(signal, &action, nullptr);
}

bool stop_asked() { return asked != 0; }

}  // namespace tw::app

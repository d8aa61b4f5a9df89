// A disk that lets the program down at a chosen step of writing; LD_PRELOAD puts it before the C library.
//
//   TWINWAKE_DISK="crash 17"      the program ends before its 17th step, as if the power were cut
//   TWINWAKE_DISK="full 17"       from the 17th step on nothing more fits: ENOSPC where a file is flushed
//   TWINWAKE_DISK="interrupt 17"  the program is sent SIGINT before its 17th step
//
// A step is a flush or a rename. Programs that twinwake starts are left alone.
#include <dlfcn.h>
#include <errno.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace {

struct Fault {
    char kind[16] = {};
    long step = 0;

    Fault() {
        const char* text = std::getenv("TWINWAKE_DISK");
        const bool ours = std::string_view(program_invocation_short_name) == "twinwake";
        if (text == nullptr || !ours || std::sscanf(text, "%15s %ld", kind, &step) != 2) kind[0] = 0;
    }
    bool is(std::string_view other) const { return kind == other; }
};

/// Whether the disk is full at this step.
bool is_full() {
    static const Fault fault;
    static std::atomic<long> steps = 0;
    const long now = ++steps;
    if (now == fault.step && fault.is("crash")) _exit(9);
    if (now == fault.step && fault.is("interrupt")) raise(SIGINT);
    return now >= fault.step && fault.is("full");
}

template <class Function>
Function* behind(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" int fsync(int file) {
    static int (*const real)(int) = behind<int(int)>("fsync");
    if (!is_full()) return real(file);
    errno = ENOSPC;
    return -1;
}

extern "C" int rename(const char* from, const char* to) noexcept {
    static int (*const real)(const char*, const char*) = behind<int(const char*, const char*)>("rename");
    is_full();  // a name takes no room
    return real(from, to);
}

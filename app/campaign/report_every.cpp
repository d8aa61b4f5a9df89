#include "app/campaign/report_every.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>

#include "app/terminal/command_words.h"
#include "app/terminal/environment_here.h"
#include "base/errors.h"
#include "foam_cases/run/child.h"
#include "record/this_machine.h"
#include "text/units.h"

namespace tw::app {
namespace {

namespace fs = std::filesystem;

double seconds_between_pages(const std::string& every) {
    try {
        if (const double seconds = quantity(every, "s"); seconds >= 1) return seconds;
    } catch (const UnitError& e) { throw InputError(fmt::format("--report-every {}: {}", every, e.what())); }
    throw InputError(fmt::format("--report-every {}: expected a time of at least one second, e.g. 10min", every));
}

}  // namespace

void refuse_report_every(const Making& making) {
    if (making.report_every.empty()) return;
    seconds_between_pages(making.report_every);
    if (making.elsewhere())
        throw InputError(
            "--report-every: the runs of this command are made elsewhere; the same command with --collect makes the "
            "page from what is finished, at any time");
}

ReportEvery::ReportEvery(const Making& making, const std::vector<std::string>& words, const fs::path& out,
                         FolderLock& lock)
    : out_(out) {
    refuse_report_every(making);
    if (making.report_every.empty()) return;
    seconds_ = seconds_between_pages(making.report_every);
    words_ = without_options(words, {{"--report-every", 1},
                                     {"--jobs", 1},
                                     {"--json", 1},
                                     {"--resume", 0},
                                     {"--overwrite", 0},
                                     {"--require", 1},
                                     {"-q", 0},
                                     {"--quiet", 0}});
    words_.insert(words_.end(), {"--collect", "--quiet"});
    environment_ = environment_here();
    environment_.push_back(lock.lend());
    thread_ = std::thread([this] { make_pages(); });
}

void ReportEvery::end() {
    if (!thread_.joinable()) return;
    {
        const std::lock_guard hold(guard_);
        ending_ = true;
    }
    news_.notify_all();
    thread_.join();
}

void ReportEvery::make_pages() {
    const fs::path log = out_ / "report_so_far.log";
    std::unique_lock hold(guard_);
    while (!news_.wait_for(hold, std::chrono::duration<double>(seconds_), [&] { return ending_; })) {
        hold.unlock();
        try {
            std::error_code ignored;
            fs::remove(log, ignored);
            ChildProcess(Command{fs::read_symlink("/proc/self/exe"), words_}, environment_, fs::current_path(), log)
                .wait();
        } catch (const std::exception&) {}  // the next one may succeed
        hold.lock();
    }
}

std::string provisional_banner(const std::vector<std::string>& unfinished) {
    if (unfinished.empty()) return {};
    return fmt::format("Provisional, as of {}: {} {} not finished ({}). Values and verdicts may change.", utc_now(),
                       unfinished.size(), unfinished.size() == 1 ? "run is" : "runs are", fmt::join(unfinished, ", "));
}

}  // namespace tw::app

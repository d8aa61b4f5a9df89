#pragma once
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "app/arguments/commands.h"
#include "base/folder_lock.h"

namespace tw::app {

/// While it lives, the study's report is made again and again from what is finished (--collect), by a process of its own
/// beside the runs; the page says that it is provisional. What that process prints goes to OUT/report_so_far.log. A page
/// that cannot be made is no failure of the study.
class ReportEvery {
public:
    /// Nothing where `making.report_every` is empty. `words`: the study's command; `lock`: of its folder `out`, lent.
    /// Throws InputError: no time, or the runs are made by somebody else.
    ReportEvery(const Making& making, const std::vector<std::string>& words, const std::filesystem::path& out,
                FolderLock& lock);
    /// Waits for a page that is just being made, so that the last report follows it.
    ~ReportEvery() { end(); }
    ReportEvery(const ReportEvery&) = delete;
    ReportEvery& operator=(const ReportEvery&) = delete;
    /// No further page.
    void end();

private:
    void make_pages();

    double seconds_ = 0;
    std::vector<std::string> words_, environment_;
    std::filesystem::path out_;
    std::mutex guard_;
    std::condition_variable news_;
    bool ending_ = false;
    std::thread thread_;
};

/// Throws InputError: --report-every is no time, or cannot be had of this command.
void refuse_report_every(const Making& making);
/// "Provisional: ... of 9 runs are not finished: ..."; empty where all are.
std::string provisional_banner(const std::vector<std::string>& unfinished);

}  // namespace tw::app

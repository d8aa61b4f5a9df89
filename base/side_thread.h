#pragma once
#include <condition_variable>
#include <ctime>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace tw {

/// Does one piece of work at a time while the caller goes on.
class SideThread {
public:
    SideThread();
    ~SideThread();  ///< waits for the work; what ends it then is lost
    SideThread(const SideThread&) = delete;
    SideThread& operator=(const SideThread&) = delete;

    /// Waits for the work before, and begins with this. Throws what ended the one before; then this is not begun.
    void begin(std::function<void()> work);
    /// Waits for the work; throws what ended it.
    void finish();
    double cpu() const;  ///< processor time that all its work has taken so far [s]

private:
    void run();

    std::mutex mutex_;
    std::condition_variable changed_;
    std::function<void()> work_;  ///< empty: none is to be done, and none is being done
    std::exception_ptr failed_;
    bool over_ = false;
    std::thread thread_;
    clockid_t clock_{};
};

}  // namespace tw

#include "base/side_thread.h"

#include <pthread.h>

#include <utility>

namespace tw {

SideThread::SideThread() : thread_([this] { run(); }) { pthread_getcpuclockid(thread_.native_handle(), &clock_); }

SideThread::~SideThread() {
    {
        const std::scoped_lock lock(mutex_);
        over_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void SideThread::begin(std::function<void()> work) {
    finish();
    {
        const std::scoped_lock lock(mutex_);
        work_ = std::move(work);
    }
    changed_.notify_all();
}

void SideThread::finish() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !work_; });
    if (failed_) std::rethrow_exception(std::exchange(failed_, nullptr));
}

double SideThread::cpu() const {
    timespec t{};
    clock_gettime(clock_, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

void SideThread::run() {
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [&] { return work_ || over_; });
        if (!work_) return;
        std::function<void()> work = std::move(work_);
        work_ = [] {};  // begun
        lock.unlock();
        std::exception_ptr failed;
        try {
            work();
        } catch (...) { failed = std::current_exception(); }
        work = nullptr;  // what it held is gone before the caller goes on
        lock.lock();
        failed_ = failed;
        work_ = nullptr;
        changed_.notify_all();
    }
}

}  // namespace tw

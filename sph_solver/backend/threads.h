#pragma once
#include <omp.h>

namespace tw {

/// Processors that this process may use.
inline int processors() { return omp_get_num_procs(); }

/// So many threads work while this lives, and as many as before when it is gone; 0: leaves it as it is.
class Threads {
public:
    explicit Threads(int wanted) : before_(omp_get_max_threads()) {
        if (wanted > 0 && wanted != before_) omp_set_num_threads(wanted);
    }
    ~Threads() {
        if (omp_get_max_threads() != before_) omp_set_num_threads(before_);
    }
    Threads(const Threads&) = delete;
    Threads& operator=(const Threads&) = delete;

private:
    int before_;
};

}  // namespace tw

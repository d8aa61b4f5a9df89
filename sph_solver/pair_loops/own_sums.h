#pragma once
#include <cstddef>

namespace tw {

struct StepView;

/// What a pair loop of an effect leaves for each particle (or dummy) that this rank owns. Of a copy of another rank's
/// it is not known before the owner has sent it, so loops over particles cannot read it: they take plain pointers,
/// which StepView::exchange gives. Only StepView makes one.
template <class T>
class OwnSums {
public:
    OwnSums() = default;
    /// For the pair loop. Always inlined: a variant's copy must not serve the whole program.
    [[gnu::always_inline]] T& operator[](std::ptrdiff_t i) const { return at_[i]; }
    /// Those from one on.
    OwnSums from(std::size_t first) const { return OwnSums(at_ + first); }

private:
    friend struct StepView;
    explicit OwnSums(T* at) : at_(at) {}
    T* at_ = nullptr;
};

}  // namespace tw

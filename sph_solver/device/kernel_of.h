#pragma once

namespace tw {

/// `KernelOf<Work>::name`: the kernel that a device has for a loop's body or for the pair loop of a view. A list of
/// kernels, LIST(line) with line(NAME, WORK) in each line, says it by LIST(TW_KERNEL_OF), of structs of this namespace
/// that are not known yet by LIST(TW_KERNEL_OF_STRUCT).
template <class Work>
struct KernelOf;

#define TW_KERNEL_OF(kernel, Work)                   \
    template <>                                      \
    struct KernelOf<Work> {                          \
        static constexpr const char* name = #kernel; \
    };
#define TW_KERNEL_OF_STRUCT(kernel, Work) \
    struct Work;                          \
    TW_KERNEL_OF(kernel, Work)

/// A loop's body, a condition or the view of a pair loop with the kernel that a device has for its type: what names the
/// kernel is the type alone. It holds the address of the work, which must live until the kernel was started.
class DeviceKernel {
public:
    template <class Work>
    DeviceKernel(const Work& work) : name_(KernelOf<Work>::name), work_(&work) {}
    const char* name() const { return name_; }
    /// As the driver wants the place of an argument, which it only reads.
    void* argument() const { return const_cast<void*>(work_); }

private:
    const char* name_;
    const void* work_;
};

}  // namespace tw

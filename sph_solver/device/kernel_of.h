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

}  // namespace tw

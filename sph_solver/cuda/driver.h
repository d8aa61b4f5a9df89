#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>

namespace tw::cuda {

/// A graphics processor of this machine through its driver, libcuda.so.1, which is looked for when it is asked for: a
/// program that finds none runs all the same. The kernels are part of the program (kernels.cpp).
///
/// All calls come from one thread at a time. Errors of the driver throw RunError with its words; where there is no
/// device that can be used, InputError says why.
class Device {
public:
    /// Of those of the machine that can be used, in the driver's order (it hides those that CUDA_VISIBLE_DEVICES does
    /// not name), the first one, or that of the process with this number: counted on from the first one after the last.
    static std::shared_ptr<Device> open(int process = 0);
    /// Why none can be used; empty: one can. Neither this nor its name opens it, which translates the kernels.
    static std::string reason_against();
    /// Of the one that would be opened; empty: there is none.
    static std::string name_here();
    static double memory_here();  ///< of that one, in use or not [B]; 0: there is none
    static int count_here();      ///< of those that can be used
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    const std::string& name() const;    ///< as its maker calls it
    const std::string& driver() const;  ///< the driver's version, as "13.0"
    std::size_t memory() const;         ///< of the device [B]
    std::size_t free_memory() const;    ///< now [B]
    int multiprocessors() const;
    /// Which it is in that order, from 1 on, and how many there are.
    int number() const;
    int of() const;
    int usable() const;  ///< of these
    /// Bytes copied since it was opened.
    struct Traffic {
        std::uint64_t to_device = 0, to_host = 0;
    };
    const Traffic& traffic() const { return traffic_; }

    /// Bytes of the device.
    std::uint64_t allocate(std::size_t bytes);
    void release(std::uint64_t at) noexcept;
    /// What these bytes hold is of no use any more. A driver that tests stand in for the real one overwrites them; that
    /// one is not asked.
    void forget(std::uint64_t at, std::size_t bytes);
    void to_device(std::uint64_t to, const void* from, std::size_t bytes);
    void to_host(void* to, std::uint64_t from, std::size_t bytes);
    void within_device(std::uint64_t to, std::uint64_t from, std::size_t bytes);
    void set_zero(std::uint64_t at, std::size_t bytes);
    /// Starts a kernel on `threads` threads, in order after all before. `arguments`: their places, as it wants them.
    void launch(const char* kernel, std::size_t threads, std::span<void*> arguments);
    /// Waits for all that was started.
    void finish();

private:
    explicit Device(int process);
    struct Library;
    std::unique_ptr<Library> library_;
    Traffic traffic_;
};

/// An array on a device.
template <class T>
class Array {
public:
    explicit Array(Device& device) : device_(&device) {}
    /// Empty for ever, unless it gets a device.
    Array() = default;
    void live_on(Device& device) { device_ = &device; }
    ~Array() { release(); }
    Array(Array&& other) noexcept
        : device_(other.device_), at_(other.at_), size_(other.size_), capacity_(other.capacity_) {
        other.at_ = 0, other.size_ = other.capacity_ = 0;
    }
    Array& operator=(Array&&) = delete;

    /// Where it is, for kernels; null: it is empty.
    T* data() const { return reinterpret_cast<T*>(at_); }
    std::size_t size() const { return size_; }
    std::size_t bytes() const { return capacity_ * sizeof(T); }
    /// What it holds is lost.
    void resize(std::size_t n) {
        size_ = n;
        if (n <= capacity_) {
            if (n > 0) device_->forget(at_, n * sizeof(T));
            return;
        }
        release();
        capacity_ = n + n / 8;
        at_ = device_->allocate(capacity_ * sizeof(T));
    }
    /// What it holds stays.
    void grow(std::size_t n) {
        if (n > capacity_) {
            Array larger(*device_);
            larger.resize(n);
            if (size_ > 0) device_->within_device(larger.at_, at_, size_ * sizeof(T));
            swap(larger);
        }
        size_ = n;
    }
    void swap(Array& other) noexcept {
        std::swap(at_, other.at_), std::swap(size_, other.size_), std::swap(capacity_, other.capacity_);
    }
    void upload(std::span<const T> from) {
        resize(from.size());
        if (size_ > 0) device_->to_device(at_, from.data(), size_ * sizeof(T));
    }
    /// Into as many elements of the host, from the first or another one on.
    void download(std::span<T> to, std::size_t first = 0) const {
        if (!to.empty()) device_->to_host(to.data(), at_ + first * sizeof(T), to.size() * sizeof(T));
    }
    /// Over those from one on.
    void upload_at(std::span<const T> from, std::size_t first) {
        if (!from.empty()) device_->to_device(at_ + first * sizeof(T), from.data(), from.size_bytes());
    }
    void copy(const Array& other) {
        resize(other.size_);
        if (size_ > 0) device_->within_device(at_, other.at_, size_ * sizeof(T));
    }
    T value(std::size_t k) const {
        T one;
        download(std::span(&one, 1), k);
        return one;
    }
    void set_zero() {
        if (size_ > 0) device_->set_zero(at_, size_ * sizeof(T));
    }

private:
    void release() {
        if (at_) device_->release(at_);
        at_ = 0, capacity_ = 0;
    }

    Device* device_ = nullptr;
    std::uint64_t at_ = 0;
    std::size_t size_ = 0, capacity_ = 0;
};

}  // namespace tw::cuda

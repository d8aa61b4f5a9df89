#include "sph_solver/levels/halo_on_device.h"

#include <vector>

#include "sph_solver/cuda/launch.h"

namespace tw {

void HaloOnDevice::set(const Halo& halo) {
    halo_ = &halo;
    sent_.upload(halo.all_sent()), received_.upload(halo.all_received());
}

void HaloOnDevice::exchange(std::initializer_list<cuda::PartOfEach> parts) {
    if (!halo_ || halo_->has_no_partners()) return;
    cuda::Message message{};
    for (const cuda::PartOfEach& part : parts) message.parts[message.count++] = part, message.of_each += part.bytes;
    const auto bytes = static_cast<std::size_t>(message.of_each);
    out_.resize(sent_.size() * bytes), in_.resize(received_.size() * bytes);
    message.which = sent_.data(), message.at = out_.data();
    cuda::launch(*device_, cuda::PackMessage{message}, sent_.size());
    std::vector<std::byte> packed(out_.size());
    out_.download(packed);
    in_.upload(halo_->exchange_packed(bytes, packed));
    message.which = received_.data(), message.at = in_.data();
    cuda::launch(*device_, cuda::UnpackMessage{message}, received_.size());
}

}  // namespace tw

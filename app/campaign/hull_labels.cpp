#include "app/campaign/hull_labels.h"

namespace tw::app {

namespace fs = std::filesystem;

std::vector<std::string> hull_labels(const std::vector<fs::path>& hulls) {
    std::vector<std::string> labels;
    std::vector<fs::path> folders;
    for (const fs::path& hull : hulls) labels.push_back(hull.stem().string()), folders.push_back(hull.parent_path());
    const auto taken = [&](std::size_t k) {
        for (std::size_t j = 0; j < hulls.size(); ++j)
            if (j != k && labels[j] == labels[k] && hulls[j] != hulls[k]) return true;
        return false;
    };
    const auto all_taken = [&] {
        std::vector<std::size_t> alike;
        for (std::size_t k = 0; k < hulls.size(); ++k)
            if (taken(k)) alike.push_back(k);
        return alike;
    };
    for (bool longer = true; longer;) {
        longer = false;
        for (const std::size_t k : all_taken()) {
            if (folders[k].filename().empty()) continue;
            labels[k] = (folders[k].filename() / labels[k]).string();
            folders[k] = folders[k].parent_path();
            longer = true;
        }
    }
    for (const std::size_t k : all_taken()) labels[k] += hulls[k].extension().string();
    return labels;
}

}  // namespace tw::app

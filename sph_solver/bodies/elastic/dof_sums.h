#pragma once
#include <vector>

#include <Eigen/Core>

#include "base/exact_sum.h"

namespace tw {

/// Sums of forces or impulses on the degrees of freedom of a structure, the same in whatever order dummies and
/// particles bring them.
class DofSums {
public:
    DofSums() = default;
    explicit DofSums(Eigen::Index dofs) : sums_(static_cast<std::size_t>(dofs)) {}
    explicit DofSums(const Eigen::VectorXd& value) : DofSums(value.size()) {
        for (std::size_t k = 0; k < sums_.size(); ++k) sums_[k] += value[static_cast<Eigen::Index>(k)];
    }
    /// To three degrees of freedom from `first` on.
    void add(Eigen::Index first, const Vec3& part) {
        for (Eigen::Index a = 0; a < 3; ++a) sums_[static_cast<std::size_t>(first + a)] += part[a];
    }
    Eigen::VectorXd value() const {
        Eigen::VectorXd value(static_cast<Eigen::Index>(sums_.size()));
        for (std::size_t k = 0; k < sums_.size(); ++k) value[static_cast<Eigen::Index>(k)] = sums_[k].value();
        return value;
    }

private:
    std::vector<ExactSum> sums_;
};

}  // namespace tw

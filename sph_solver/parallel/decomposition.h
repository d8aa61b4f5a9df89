#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "sph_solver/domain/mirrors.h"
#include "sph_solver/neighbours/pencils.h"

namespace tw {

/// Which rank owns which pencils of a level, and which others hold a copy of them.
///
/// By recursive bisection (Berger & Bokhari 1987, doi:10.1109/TC.1987.1676942): the pencils are sorted along the longer
/// side of the box round them and cut where the work on both sides is as the number of ranks there, until each has one
/// part. A cut may end within a row of pencils, so the parts' work is equal to within that of a pencil. It is the
/// method that partitioning libraries call RCB; on a plane of pencils it is shorter than the call of one, and needs no
/// messages, because all ranks know the work of all pencils.
class Decomposition {
public:
    /// One rank, which owns all.
    Decomposition() = default;
    /// `work` of each pencil in any unit; all ranks give the same. `blocks`: those pencils, or wider ones that each
    /// hold whole ones of them, which go to the same rank.
    Decomposition(const PencilGrid& grid, const PencilGrid& blocks, std::span<const std::int64_t> work, int ranks);

    int owner(int pencil) const { return owner_.empty() ? 0 : owner_[static_cast<std::size_t>(pencil)]; }

    /// Finds who needs a copy of a pencil: ranks that own a pencil within `reach` [fixed-point units] of it or of one
    /// of its mirror images. `low`, `high`: the domain's faces [fixed-point units].
    void find_holders(const PencilGrid& grid, const Mirrors& mirrors, const WidePlace& low, const WidePlace& high,
                      std::int64_t reach);
    /// Ranks but the owner that hold a copy of a pencil, in ascending order.
    std::span<const std::int32_t> holders(int pencil) const {
        if (first_.empty()) return {};
        const auto c = static_cast<std::size_t>(pencil);
        return {holders_.data() + first_[c], holders_.data() + first_[c + 1]};
    }
    bool holds(int rank, int pencil) const;

private:
    std::vector<std::int32_t> owner_;
    std::vector<std::int32_t> holders_;
    std::vector<std::size_t> first_;  ///< of each pencil's holders
};

}  // namespace tw

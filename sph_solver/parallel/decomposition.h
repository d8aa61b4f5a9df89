#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "sph_solver/domain/mirrors.h"
#include "sph_solver/neighbours/columns.h"

namespace tw {

/// Which rank owns which columns of a level, and which others hold a copy of them.
///
/// By recursive bisection (Berger & Bokhari 1987, doi:10.1109/TC.1987.1676942): the columns are sorted along the longer
/// side of the box round them and cut where the work on both sides is as the number of ranks there, until each has one
/// part. A cut may end within a row of columns, so the parts' work is equal to within that of a column. It is the
/// method that partitioning libraries call RCB; on a plane of columns it is shorter than the call of one, and needs no
/// messages, because all ranks know the work of all columns.
class Decomposition {
public:
    /// One rank, which owns all.
    Decomposition() = default;
    /// `work` of each column in any unit; all ranks give the same. `blocks`: those columns, or wider ones that each
    /// hold whole ones of them, which go to the same rank.
    Decomposition(const ColumnGrid& grid, const ColumnGrid& blocks, std::span<const std::int64_t> work, int ranks);

    int owner(int column) const { return owner_.empty() ? 0 : owner_[static_cast<std::size_t>(column)]; }

    /// Finds who needs a copy of a column: ranks that own a column within `reach` [fixed-point units] of it or of one
    /// of its mirror images. `low`, `high`: the domain's faces [fixed-point units].
    void find_holders(const ColumnGrid& grid, const Mirrors& mirrors, const WidePlace& low, const WidePlace& high,
                      std::int64_t reach);
    /// Ranks but the owner that hold a copy of a column, in ascending order.
    std::span<const std::int32_t> holders(int column) const {
        if (first_.empty()) return {};
        const auto c = static_cast<std::size_t>(column);
        return {holders_.data() + first_[c], holders_.data() + first_[c + 1]};
    }
    bool holds(int rank, int column) const;

private:
    std::vector<std::int32_t> owner_;
    std::vector<std::int32_t> holders_;
    std::vector<std::size_t> first_;  ///< of each column's holders
};

}  // namespace tw

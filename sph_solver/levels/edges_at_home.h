#pragma once
#include <vector>

#include "sph_solver/levels/edge_steps.h"

namespace tw {

class Level;

/// The edges of a level whose steps this processor makes.
class EdgesAtHome : public EdgeSteps {
public:
    /// `level` must outlive this.
    explicit EdgesAtHome(Level& level) : level_(level) {}

    void label(const AskEdge& ask, LabelCoarse label, const Zone& zone) override;
    Spray label(const AskEdge& ask, LabelFine label, const Zone& zone, EdgeSteps& coarser,
                const Asking& asking) override;
    std::int64_t remove_gone(const std::vector<std::size_t>& more) override;
    std::vector<Parent> find_parents(double within) override;
    std::vector<Located> between(double from, double to) override;
    std::vector<Located> guards() override;
    void add(const std::vector<Child>& children) override;
    void forget_edge(With whose) override;
    void interpolate(FieldsAt& at) override;
    Followed follow_coarser(EdgeSteps& coarser, const Asking& asking, FollowCoarser follow) override;
    Followed follow_finer(EdgeSteps& finer, const Asking& asking, FollowFiner follow) override;

private:
    Level& level_;
    std::vector<double> outside_;  ///< of each particle from the edge of the finer zone, at the last labelling [m]
    std::vector<int> gone_;        ///< of each particle of a level that has guards
};

}  // namespace tw

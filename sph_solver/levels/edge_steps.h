#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "meshes/zone.h"
#include "sph_solver/fields/field_table.h"
#include "sph_solver/levels/fields_at.h"
#include "sph_solver/loops/at_edge.h"
#include "sph_solver/loops/edge_labels.h"

namespace tw {

/// What is done to a level's particles where it meets a level of another size, by processor or device: who they
/// are, who comes and goes, whose fields they follow. What for, and in which order, says Refinement.
class EdgeSteps {
public:
    virtual ~EdgeSteps() = default;

    /// What this level's particles are by the edge of a finer level's zone.
    virtual void label(const AskEdge& ask, LabelCoarse label, const Zone& zone) = 0;
    /// And by that of its own zone, where the coarser level is asked about those outside. Some are gone from then on.
    struct Spray {
        std::int64_t count = 0;
        std::vector<Located> far{};  ///< those of them where buffer particles are gone
    };
    virtual Spray label(const AskEdge& ask, LabelFine label, const Zone& zone, EdgeSteps& coarser,
                        const Asking& asking) = 0;
    /// Takes those away that are gone, and some more; how many.
    virtual std::int64_t remove_gone(const std::vector<std::size_t>& more) = 0;
    /// Those nearer to the edge of the finer level's zone, or under it; all their daughters are there from then on.
    virtual std::vector<Parent> find_parents(double within) = 0;
    virtual std::vector<Located> between(double from, double to) = 0;  ///< distances from that edge
    virtual std::vector<Located> buffers() = 0;
    virtual void add(const std::vector<Child>& daughters) = 0;
    /// Distances from the edge of the level's own zone (With::coarser) or a finer level's are no longer known.
    virtual void forget_edge(With whose) = 0;
    /// As LevelFields::interpolate.
    virtual void interpolate(FieldsAt& at) = 0;
    /// Lets the buffer particles of this level follow a coarser one, and what stands for a finer level's water that
    /// one.
    virtual Followed follow_coarser(EdgeSteps& coarser, const Asking& asking, FollowCoarser follow) = 0;
    virtual Followed follow_finer(EdgeSteps& finer, const Asking& asking, FollowFiner follow) = 0;
};

}  // namespace tw

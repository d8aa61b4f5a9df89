#include "app/arguments/output.h"
#include "compare/uncertainty/refinement_table.h"
#include "compare/uncertainty/report_uncertainty.h"

namespace tw::app {

int run_uncertainty(const UncertaintyCommand& command, const Common& common) {
    const RefinementTable table = read_refinement_table(command.table, command.dimensions);
    std::vector<QuantityEstimate> quantities;
    for (const RefinementTable::Column& column : table.columns) {
        std::vector<StudyLevel> levels;
        for (std::size_t i = 0; i < table.spacing.size(); ++i)
            levels.push_back({table.spacing[i], column.values[i], 0, column.rounding});
        quantities.push_back({column.name, estimate(std::move(levels), command.order)});
    }
    say(common, uncertainty_text(quantities, table.spacing_name));
    write_json(common, uncertainty_json(quantities, table.spacing_name));
    return done;
}

}  // namespace tw::app

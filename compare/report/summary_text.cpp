#include <fmt/format.h>

#include "compare/compare.h"
#include "compare/report/comparison_tables.h"
#include "compare/report/escape.h"
#include "compare/report/numbers.h"
#include "compare/report/sentences.h"

namespace tw {

std::string summary_text(const Comparison& comparison) {
    std::string out;
    for (const std::string& sentence : verdict_sentences(comparison)) out += for_terminal(sentence) + "\n";
    for (const std::string& b : comparison.banners) out += "! " + for_terminal(b) + "\n";
    for (const ReportTable& table :
         {quantities_table(comparison, true), left_out_table(comparison), quantities_table(comparison, false),
          checks_table(comparison.gates, true), cost_table(comparison)})
        if (!table.empty()) out += (out.empty() ? "" : "\n") + text_of(table);
    return out;
}

}  // namespace tw

#pragma once
#include <algorithm>
#include <string>
#include <vector>

namespace tw {

/// The kinds of quantities (record/effect_choice.h) that a quantity is one of, by its name: what an effect says of the
/// first that it knows counts. Empty: no plan speaks of it.
std::vector<std::string> kinds_of(std::string quantity);

/// Where a quantity stands among those that a first page speaks of, by its name; negative: it is not one of them. Total
/// drag, drag, lift, trim moment and running attitude of a hull; way, velocity, largest force and strains of a body that moves; impulse and largest
/// force on what stands in a tank; the splash sheet.
int main_rank(const std::string& name);
inline bool is_main_quantity(const std::string& name) { return main_rank(name) >= 0; }
/// Those of a list, in that order, without those that are shown beside and never judged.
template <class Quantities>
auto main_quantities(const Quantities& all) {
    std::vector<decltype(all.data())> of_all;
    const auto only_beside = [](const auto& q) {
        if constexpr (requires { q.judged_in_grid_study; })
            return !q.judged && !q.judged_in_grid_study && q.not_resolved.empty();
        else
            return false;
    };
    for (const auto& q : all)
        if (is_main_quantity(q.name) && !only_beside(q)) of_all.push_back(&q);
    std::ranges::stable_sort(of_all, {}, [](const auto* q) { return main_rank(q->name); });
    return of_all;
}

}  // namespace tw

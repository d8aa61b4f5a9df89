#include "statistics/flow_through.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "record/record_numbers.h"

namespace tw {

double flow_through_time(const RunRecord& record) {
    const double speed = number_of(record, "speed", 0), length = number_of(record, "length", 0);
    if (!(speed > 0) || !(length > 0)) return 0;
    const double trim = number_of(record, "trim", 0), draft = number_of(record, "draft", 0);
    double wet = trim > 0 && draft > 0 ? std::min(length, draft / std::sin(trim)) : length;
    if (const Column* c = record.series("samples", "wetted_length")) {
        std::vector<double> known;
        const auto& time = record.tables.at("samples").time;
        for (std::size_t i = 0; i < c->values.size(); ++i)
            if (c->values[i] > 0 && time[i] >= number_of(record, "mean_from", 0)) known.push_back(c->values[i]);
        if (!known.empty()) {
            std::ranges::nth_element(known, known.begin() + static_cast<std::ptrdiff_t>(known.size() / 2));
            wet = std::min(length, known[known.size() / 2]);
        }
    }
    return wet / speed;
}

}  // namespace tw

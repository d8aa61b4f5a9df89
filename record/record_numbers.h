#pragma once
#include <string>

#include "record/run_record.h"

namespace tw {

/// A number of a record; `fallback` where it is absent or not finite.
double number_of(const RunRecord& record, const std::string& name, double fallback);
/// A number that a record holds as an attribute's text ("2"); `fallback` where it is absent or no number.
double number_of_text(const RunRecord& record, const std::string& name, double fallback);
std::string text_of(const RunRecord& record, const std::string& name, const std::string& fallback = {});

bool has_moving_bodies(const RunRecord& record);
/// A hull in a stream settles; a tank (dam break, impact) has its say once.
bool is_stream(const RunRecord& record);

}  // namespace tw

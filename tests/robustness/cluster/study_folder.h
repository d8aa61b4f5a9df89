#pragma once
#include <map>
#include <nlohmann/json.hpp>

#include "../app/program.h"
#include "../runs/first_difference.h"
#include "record/run_record.h"

namespace tw::test {

inline bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A grid study of three sizes with 350 particles at most.
inline const std::string small_column =
    with(falling_column("column", "duration = 0.1\ncheckpoint = 0.02", "[0.4, 0.1, 0.02]"), "near_hull = 0.02",
         "near_hull = 0.03");

/// The records below two folders of results, by their path in it.
inline std::set<std::string> records_below(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().filename() == "record.h5") names.insert(fs::relative(entry.path(), folder).string());
    return names;
}

/// Two folders of results hold the same records, to the last bit, but for where and when they were made.
inline void expect_same_records(const fs::path& a, const fs::path& b) {
    EXPECT_EQ(records_below(a), records_below(b));
    for (const std::string& name : records_below(a)) {
        const RunRecord of_a = read_record(a / name), of_b = read_record(b / name);
        EXPECT_EQ(of_a.state, of_b.state) << name;
        EXPECT_EQ(first_difference(of_a, of_b), "") << name;
        EXPECT_EQ(of_a.attributes.at("command"), of_b.attributes.at("command")) << name;
        EXPECT_EQ(of_a.attributes.at("run_hash"), of_b.attributes.at("run_hash")) << name;
    }
}

/// Two folders of results hold the same tables (CSV), but for what an ablation's runs cost.
inline void expect_same_tables(const fs::path& a, const fs::path& b) {
    const auto tables = [](const fs::path& folder) {
        std::map<std::string, std::string> all;
        for (const auto& entry : fs::recursive_directory_iterator(folder)) {
            if (entry.path().extension() != ".csv") continue;
            std::ifstream file(entry.path());
            std::string& text = all[fs::relative(entry.path(), folder).string()];
            for (std::string line; std::getline(file, line);)
                if (!has(line, ",cost,")) text += line + "\n";
        }
        return all;
    };
    const auto of_a = tables(a), of_b = tables(b);
    EXPECT_FALSE(of_a.empty());
    EXPECT_EQ(of_a, of_b);
}

}  // namespace tw::test

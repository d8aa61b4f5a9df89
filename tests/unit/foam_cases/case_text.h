#pragma once
#include <string>

namespace tw {

/// Text of an OpenFOAM file whose blanks and ends of lines are one blank.
inline std::string without_blanks(std::string text) {
    std::string out;
    for (const char c : text) {
        const bool blank = c == ' ' || c == '\n';
        if (!blank)
            out += c;
        else if (!out.empty() && out.back() != ' ')
            out += ' ';
    }
    return out;
}

}  // namespace tw

#define EXPECT_SAYS(file, part) EXPECT_NE(without_blanks(file).find(part), std::string::npos) << (file)
#define EXPECT_SILENT(file, part) EXPECT_EQ(without_blanks(file).find(part), std::string::npos) << (file)

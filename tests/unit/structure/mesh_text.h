#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "base/errors.h"
#include "structure/read_mesh.h"

namespace tw::structure {

inline std::filesystem::path written(const std::string& text, const std::string& ending) {
    const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
    const auto file = std::filesystem::temp_directory_path() / (test + ending);
    std::ofstream(file) << text;
    return file;
}

/// What reading the text as a file of this ending is refused with, without the file's name; empty: it is read.
inline std::string refusal(const std::string& text, const std::string& ending) {
    const std::string file = written(text, ending).string();
    try {
        read_mesh(file);
    } catch (const InputError& e) {
        const std::string message = e.what();
        return message.starts_with(file) ? message.substr(file.size()) : "the file is not named: " + message;
    }
    return {};
}

inline std::string with(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    if (at == std::string::npos) throw std::logic_error("the test's mesh has no " + from);
    return text.replace(at, from.size(), to);
}

}  // namespace tw::structure

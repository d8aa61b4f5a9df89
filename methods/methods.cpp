#include "methods/methods.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/errors.h"
#include "methods/names.h"

namespace tw {

const std::vector<Method>& methods() {
    static const std::vector<Method> rows{
        {.name = sph_method, .label = "SPH", .elements = "particles"},
        {.name = fvm_method, .label = "interFoam", .elements = "cells"},
    };
    return rows;
}

std::vector<std::string> method_names() {
    std::vector<std::string> names;
    for (const Method& m : methods()) names.push_back(m.name);
    return names;
}

const Method* find_method(const std::string& name) {
    const auto row = std::ranges::find(methods(), name, &Method::name);
    return row == methods().end() ? nullptr : &*row;
}

const Method& method_named(const std::string& name) {
    if (const Method* row = find_method(name)) return *row;
    throw InputError(
        fmt::format("{}: there is no such method; expected one of: {}", name, fmt::join(method_names(), ", ")));
}

std::size_t method_rank(const std::string& name) {
    return static_cast<std::size_t>(std::ranges::find(methods(), name, &Method::name) - methods().begin());
}

std::string method_label(const std::string& name) {
    const std::size_t end = std::min(name.find(' '), name.size());
    const Method* row = find_method(name.substr(0, end));
    return row ? row->label + name.substr(end) : name;
}

std::string elements_of(const std::string& name) {
    const Method* row = find_method(name);
    return row ? row->elements : "elements";
}

std::string elements_of_all() {
    std::vector<std::string> words;
    for (const Method& m : methods())
        if (std::ranges::find(words, m.elements) == words.end()) words.push_back(m.elements);
    return fmt::format("{}", fmt::join(words, " or "));
}

}  // namespace tw

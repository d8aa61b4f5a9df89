#include "app/progress/member_state.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/errors.h"
#include "base/own_json.h"

namespace tw::app {
namespace {

constexpr std::array kind_names = {"waiting", "running", "done", "stopped", "failed", "refused"};

}  // namespace

std::string name_of(MemberState::Kind kind) { return kind_names.at(static_cast<std::size_t>(kind)); }

MemberState::Kind kind_of_name(const std::string& name) {
    const auto* const kind = std::ranges::find(kind_names, name);
    if (kind == kind_names.end()) throw InputError("no state of a run: " + name);
    return static_cast<MemberState::Kind>(kind - kind_names.begin());
}

MemberState read_member_state(const std::filesystem::path& file) {
    if (!std::filesystem::exists(file)) return {};
    MemberState s;
    try {
        read_own_json(file, [&](const nlohmann::json& facts) {
            const MemberState::Kind kind = kind_of_name(facts.at("state").get<std::string>());
            s.why = facts.at("why"), s.note = facts.at("note"), s.node = facts.at("node");
            s.share = number_within(facts, "share", 0, 1), s.left = number_within(facts, "left", 0, 1e12);
            s.kind = kind;
        });
    } catch (const InputError&) { return {}; }
    return s;
}

void write_member_state(const std::filesystem::path& file, const MemberState& s) {
    const nlohmann::ordered_json facts = {{"state", name_of(s.kind)}, {"why", s.why},
                                          {"share", s.share},         {"left", std::isfinite(s.left) ? s.left : 0},
                                          {"note", s.note},           {"node", s.node}};
    replace_quietly(file, facts.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

void replace_quietly(const std::filesystem::path& file, const std::string& text) {
    const std::filesystem::path beside = file.string() + ".tmp";
    const bool whole = static_cast<bool>((std::ofstream(beside, std::ios::binary) << text).flush());
    std::error_code ignored;  // nothing is lost with it, so it need not be on the disk at once
    if (whole)
        std::filesystem::rename(beside, file, ignored);
    else
        std::filesystem::remove(beside, ignored);
}

}  // namespace tw::app

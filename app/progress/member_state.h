#pragma once
#include <filesystem>
#include <string>

namespace tw::app {

/// How far a run of a study has come. The process that makes it replaces its file once a second, so that whoever runs,
/// collects or watches the study can read it, on this machine or on another that sees the folder.
struct MemberState {
    enum class Kind {
        waiting,  ///< not begun
        running,
        done,
        stopped,  ///< on request, with its state saved
        failed,   ///< begun, and not finished: `why`
        refused   ///< not begun, by what is wrong with it: `why`
    };
    Kind kind = Kind::waiting;
    std::string why;
    double share = 0, left = 0;  ///< of the simulated time; wall time left [s], 0: not known
    std::string note;            ///< what it does
    std::string node;            ///< the machine it runs on

    bool ended() const { return kind != Kind::waiting && kind != Kind::running; }
};
std::string name_of(MemberState::Kind kind);
/// Throws InputError: there is none of this name.
MemberState::Kind kind_of_name(const std::string& name);

/// Waiting where there is no file, or none that can be read.
MemberState read_member_state(const std::filesystem::path& file);
/// A state that cannot be written is left out silently: a run continues without it.
void write_member_state(const std::filesystem::path& file, const MemberState& state);
/// Under a temporary name, and renamed; quietly nothing where it cannot be written.
void replace_quietly(const std::filesystem::path& file, const std::string& text);

}  // namespace tw::app

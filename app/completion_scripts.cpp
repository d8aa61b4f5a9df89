#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "app/completion.h"

namespace tw::app {
namespace {

/// One word of a shell, whatever it holds.
std::string in_quotes(const std::string& text) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + "'";
}

std::vector<std::string> names_of(const std::vector<OfferedCommand>& commands) {
    std::vector<std::string> names;
    for (const OfferedCommand& c : commands) names.push_back(c.path.substr(c.path.rfind(' ') + 1));
    return names;
}

/// Calls `use` with the command and all below it.
template <class Use>
void for_all(const OfferedCommand& command, Use use) {
    use(command);
    for (const OfferedCommand& c : command.below) for_all(c, use);
}

/// The words that may follow where no value of an option is expected.
std::string words_of(const OfferedCommand& command) {
    std::vector<std::string> words = names_of(command.below);
    words.insert(words.end(), command.words.begin(), command.words.end());
    for (const OfferedOption& o : command.options) words.insert(words.end(), o.names.begin(), o.names.end());
    return fmt::format("{}", fmt::join(words, " "));
}

}  // namespace

std::string bash_completion(const OfferedCommand& program) {
    std::vector<std::string> paths;
    std::string values, words;
    for_all(program, [&](const OfferedCommand& c) {
        if (!c.path.empty()) paths.push_back(in_quotes(c.path));
        for (const OfferedOption& o : c.options) {
            if (!o.takes_value) continue;
            std::vector<std::string> cases;
            for (const std::string& name : o.names) cases.push_back(in_quotes(c.path + " " + name));
            values += fmt::format("        {}) words={} files={} ;;\n", fmt::join(cases, " | "),
                                  in_quotes(fmt::format("{}", fmt::join(o.values, " "))), o.takes_file ? 1 : 0);
        }
        words += fmt::format("            {}) words={} files={} ;;\n", in_quotes(c.path), in_quotes(words_of(c)),
                             c.takes_file ? 1 : 0);
    });
    return fmt::format(R"(# Completion of the command twinwake, as it is now:  source <(twinwake completion bash)
_twinwake() {{
    local word=${{COMP_WORDS[COMP_CWORD]}} command="" words="" files=0 k next
    for ((k = 1; k < COMP_CWORD; k++)); do
        next="${{command:+$command }}${{COMP_WORDS[k]}}"
        case $next in
            {}) command=$next ;;
        esac
    done
    case "$command ${{COMP_WORDS[COMP_CWORD - 1]}}" in
{}        *) case $command in
{}        esac ;;
    esac
    COMPREPLY=($(compgen -W "$words" -- "$word"))
    if [ "$files" = 1 ]; then
        local IFS=$'\n'
        COMPREPLY+=($(compgen -f -- "$word"))
    fi
}}
complete -o filenames -F _twinwake twinwake
)",
                       fmt::join(paths, " | "), values, words);
}

std::string zsh_completion(const OfferedCommand& program) {
    // Also as the file _twinwake of zsh's own folder: that is run where its first completion is asked for.
    return "#compdef twinwake\n# source <(twinwake completion zsh)\nautoload -U +X compinit bashcompinit\n"
           "whence compdef >/dev/null || compinit\nbashcompinit\n" +
           bash_completion(program) + "if [[ ${funcstack[1]} == _twinwake ]]; then _bash_complete -F _twinwake; fi\n";
}

std::string fish_completion(const OfferedCommand& program) {
    std::string text = "# twinwake completion fish | source\ncomplete -c twinwake -f\n";
    for_all(program, [&](const OfferedCommand& c) {
        std::string here = "__fish_use_subcommand";
        if (!c.path.empty()) {
            here = "__fish_seen_subcommand_from " + c.path.substr(0, c.path.find(' '));
            if (const std::size_t blank = c.path.find(' '); blank != c.path.npos)
                here += "; and __fish_seen_subcommand_from " + c.path.substr(blank + 1);
            else if (!c.below.empty())
                here += fmt::format("; and not __fish_seen_subcommand_from {}", fmt::join(names_of(c.below), " "));
        }
        const std::string line = "complete -c twinwake -n " + in_quotes(here);
        const std::vector<std::string> names = names_of(c.below);
        for (std::size_t k = 0; k < names.size(); ++k)
            text += fmt::format("{} -a {} -d {}\n", line, names[k], in_quotes(c.below[k].help));
        if (!c.words.empty())
            text += fmt::format("{} -a {}\n", line, in_quotes(fmt::format("{}", fmt::join(c.words, " "))));
        if (c.takes_file) text += line + " -F\n";
        for (const OfferedOption& o : c.options) {
            text += line;
            for (const std::string& name : o.names)
                text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
            if (o.takes_value) text += o.takes_file ? " -r -F" : " -x";
            if (!o.values.empty()) text += " -a " + in_quotes(fmt::format("{}", fmt::join(o.values, " ")));
            text += " -d " + in_quotes(o.help) + "\n";
        }
    });
    return text;
}

}  // namespace tw::app

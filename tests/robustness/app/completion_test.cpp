// What a shell offers is what the program takes: the list comes from the command line's own definition, and is held
// against what --help prints.
#include <algorithm>
#include <sstream>

#include "program.h"

namespace tw::test {
namespace completion_test {

using Words = std::vector<std::string>;

/// First words of the lines of a help text that are indented by two blanks, from the line `heading` on.
Words entries(const std::string& help, const std::string& heading) {
    Words words;
    std::istringstream lines(help.substr(std::min(help.find("\n" + heading + ":\n"), help.size())));
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("  ") && line.size() > 2 && line[2] != ' ')
            words.push_back(line.substr(2, line.find(' ', 2) - 2));
    return words;
}

/// "-q,--quiet" apart.
Words spellings(const Words& options) {
    Words all;
    for (const std::string& option : options) {
        std::istringstream names(option);
        for (std::string name; std::getline(names, name, ',');)
            if (name.starts_with('-')) all.push_back(name.substr(0, name.find('{')));  // --no-twins{false}
    }
    return all;
}

class Completion : public Command {
protected:
    /// What bash offers when the last of the words is being typed.
    Words offered(const Words& words) {
        std::string script = "source <(" TWINWAKE_PROGRAM " completion bash)\nCOMP_WORDS=(twinwake";
        for (const std::string& word : words) script += " '" + word + "'";
        write("complete.sh", script +
                                 ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_twinwake\n"
                                 "printf '%s\\n' \"${COMPREPLY[@]}\" > offered\n");
        EXPECT_EQ(std::system(("cd '" + folder_.string() + "' && bash complete.sh").c_str()), 0);
        std::istringstream lines(content(folder_ / "offered"));
        Words all;
        for (std::string line; std::getline(lines, line);) all.push_back(line);
        return all;
    }
    static bool has(const Words& words, const std::string& word) {
        return std::ranges::find(words, word) != words.end();
    }
};

TEST_F(Completion, OffersEverySubcommandAndEveryOptionThatHelpLists) {
    Words commands = entries(twinwake({"--help"}).out, "Subcommands");
    ASSERT_GE(commands.size(), 16u);
    for (const std::string& command : commands) EXPECT_TRUE(has(offered({""}), command)) << command;
    const Words actions = entries(twinwake({"hull", "--help"}).out, "Subcommands");
    ASSERT_EQ(actions.size(), 4u);
    for (const std::string& action : actions) EXPECT_TRUE(has(offered({"hull", ""}), action)) << action;
    for (const std::string& action : actions) commands.push_back("hull " + action);
    const std::string fish = twinwake({"completion", "fish"}).out, man = twinwake({"completion", "man"}).out;
    for (const std::string& command : commands) {
        Words words, call;
        std::istringstream parts(command);
        for (std::string part; parts >> part;) words.push_back(part);
        call = words;
        call.push_back("--help");
        const Words options = spellings(entries(twinwake(call).out, "Options"));
        ASSERT_TRUE(has(options, "--help")) << command;
        words.push_back("-");
        const Words offers = offered(words);
        std::string heading = command;
        for (std::size_t k = 0; (k = heading.find('-', k)) != heading.npos; k += 2) heading.insert(k, "\\");
        const std::size_t section = man.find("\n.SS \"twinwake " + heading + "\"\n");
        const std::string page =
            section == man.npos ? "" : man.substr(section, man.find("\n.S", section + 1) - section);
        for (const std::string& option : options) {
            EXPECT_TRUE(has(offers, option)) << command << " " << option;
            std::string in_page = option;
            for (std::size_t k = 0; (k = in_page.find('-', k)) != in_page.npos; k += 2) in_page.insert(k, "\\");
            EXPECT_NE(page.find("\\fB" + in_page + "\\fR"), page.npos) << command << " " << option;
            if (!option.starts_with("--")) continue;
            bool in_fish = false;  // a line for this subcommand with this option
            std::istringstream lines(fish);
            for (std::string line; std::getline(lines, line) && !in_fish;)
                in_fish = line.find("_from " + words[0]) != line.npos &&
                          (line + " ").find(" -l " + option.substr(2) + " ") != line.npos;
            EXPECT_TRUE(in_fish) << command << " " << option;
        }
    }
    EXPECT_TRUE(has(offered({"spray", "study.toml", "--a"}), "--against"));
}

TEST_F(Completion, OffersTheValuesThatAnOptionTakes) {
    write("here.stl", "");
    EXPECT_EQ(offered({"run", "a.toml", "--method", ""}), (Words{"sph", "fvm", "both"}));
    EXPECT_EQ(offered({"run", "a.toml", "--method", "f"}), Words{"fvm"});
    EXPECT_EQ(offered({"run", "a.toml", "--threads", "h"}), Words{""}) << "a number is no file";
    EXPECT_EQ(offered({"run", "a.toml", "--hull", "h"}), Words{"here.stl"});
    EXPECT_TRUE(has(offered({"run", "h"}), "here.stl"));
    EXPECT_EQ(offered({"new", "pl"}), Words{"planing"});
    EXPECT_TRUE(has(offered({"hull", "make", ""}), "prismatic"));
    EXPECT_EQ(offered({"hull", "info", "here.stl", "--unit", ""}), (Words{"m", "mm", "cm", "ft", "in"}));
    EXPECT_EQ(offered({"check", "a.toml", "--effect", "visc"}), (Words{"viscosity=on", "viscosity=off"}));
    EXPECT_EQ(offered({"ablate", "a.toml", "--effects", "visc"}), Words{"viscosity"});
    EXPECT_EQ(offered({"completion", "f"}), Words{"fish"});
}

TEST_F(Completion, AShellThatIsNotKnownIsRefused) {
    const Outcome o = twinwake({"completion", "tcsh"});
    EXPECT_EQ(o.status, 2);
    EXPECT_NE(o.err.find("bash"), std::string::npos) << o.err;
    EXPECT_NE(twinwake({"completion", "zsh"}).out.find("bashcompinit"), std::string::npos);
}

}  // namespace completion_test
}  // namespace tw::test

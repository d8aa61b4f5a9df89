#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace tw {

/// Time folders of an OpenFOAM case, in its root or in its processor folders.
class TimeFolders {
public:
    explicit TimeFolders(std::filesystem::path case_folder);

    const std::vector<std::filesystem::path>& roots() const {
        return roots_;
    }  ///< the case, or processor0, processor1, ...
    bool decomposed() const { return roots_.front() != case_; }

    struct Moment {
        double time = 0;  ///< [s]
        std::string name;
    };
    /// Times after 0 that exist in any root, ascending.
    std::vector<Moment> moments() const;
    /// Every field that a restart needs is there in every root, and it and all that lies in `uniform` (the state of
    /// bodies and function objects) is written to its end. OpenFOAM writes straight into the final names; a whole file
    /// ends in a closing comment line.
    bool whole(const Moment& moment) const;
    void remove(const Moment& moment) const;

    /// Drops folders that a killed solver left half-written, and, where `interval` > 0, those that lie off its
    /// multiples (written because a stop was asked for): going on from them would shift all later write times. Returns
    /// the names that were dropped.
    std::vector<std::string> prune(double interval) const;

    /// Removes what function objects have left for times later than `restart` [s]: surfaces, and tables of starts of
    /// the solver whose state is no longer there. They would be taken for the new start's.
    void forget_output_after(double restart) const;

private:
    std::filesystem::path case_;
    std::vector<std::filesystem::path> roots_;
    std::vector<std::string> fields_;
};

}  // namespace tw

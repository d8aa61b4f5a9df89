#pragma once
#include "scene/keys/keys.h"
#include "text/section.h"

namespace tw {

/// A section of the scene file. Getters that take a key alone find its kind, unit, range and choices in the table
/// (keys.h); those of Section serve what is in no table: parameters of shapes.
class SceneSection : public Section {
public:
    using Section::Section;
    explicit SceneSection(Section section) : Section(std::move(section)) {}

    using Section::choice, Section::choices, Section::number, Section::numbers, Section::range, Section::vector;
    std::optional<double> number(const std::string& key);
    double number(const std::string& key, double fallback) { return number(key).value_or(fallback); }
    std::optional<int> whole(const std::string& key);
    std::optional<std::vector<double>> numbers(const std::string& key);
    std::optional<Vec3> vector(const std::string& key) { return vector(key, row(key).unit); }
    std::optional<std::pair<double, double>> range(const std::string& key) { return range(key, row(key).unit); }
    std::optional<std::string> choice(const std::string& key);
    std::optional<bool> on_off(const std::string& key) { return Section::on_off(written(row(key))); }
    std::optional<std::vector<std::string>> choices(const std::string& key) { return choices(key, row(key).choices); }

    /// Reads every key of the table's section that has a slot in the scene; what is not written is left as it is.
    void read_into(Scene& scene);
    /// A new Scene with one entry of this repeated section, in which every key that has a slot is read.
    Scene entry();

private:
    /// Its name in the table: repeated sections stand there without their brackets.
    std::string table_name() const;
    void read_slot(const SceneKey& key, Scene& scene);
    const SceneKey& row(const std::string& key) const;
    /// The spelling in which a key was written: an older one where the file has that. Throws when it has both.
    std::string written(const SceneKey& key);
};

}  // namespace tw

#include "scene/keys/keys.h"

#include <map>
#include <set>

#include "base/atomic_file.h"
#include "every_key.h"
#include "scene/hash.h"
#include "scene/reference.h"
#include "test_paths.h"

namespace tw::test {
namespace keys_test {

TEST(Keys, EachKeyIsCoveredByTheHashThatTheTableNames) {
    const auto all = changes();
    for (const SceneKey& key : scene_keys()) {
        if (key.kind == SceneKey::Kind::on_off) continue;  // effects: effects_test
        const std::string name = key.section + "." + key.name;
        if (name == "hull.repair") continue;  // it changes only surfaces that are refused without it
        ASSERT_TRUE(all.contains(name)) << name << " has no change in this test";
        const auto& [before, after] = all.at(name);
        Scene a, b;
        ASSERT_NO_THROW(a = scene_of(before)) << name;
        ASSERT_NO_THROW(b = scene_of(after)) << name;
        const bool in_scene = key.hashed == SceneKey::Hashed::scene, in_run = key.hashed == SceneKey::Hashed::run;
        EXPECT_EQ(a.hash != b.hash, in_scene) << name;
        for (const char* method : {"sph", "fvm"})
            EXPECT_EQ(run_hash(a, method) != run_hash(b, method),
                      in_scene || (in_run && (key.section == method || !find_method(key.section))))
                << name << " " << method;
        // The family's hash covers the same, but for the sizes.
        const bool size =
            key.section == "resolution" || name == "sph.levels" || name == "body.skin" || name == "body.margin";
        EXPECT_EQ(family_hash(a, "sph") != family_hash(b, "sph"), !size && run_hash(a, "sph") != run_hash(b, "sph"))
            << name;
        EXPECT_EQ(family_hash(a, "fvm") != family_hash(b, "fvm"), !size && run_hash(a, "fvm") != run_hash(b, "fvm"))
            << name;
    }
}

TEST(Keys, OnlyWhatChangesNothingThatIsSolvedIsInNoHash) {
    const std::set<std::string> in_none{".title",
                                        "run.duration",
                                        "run.methods",
                                        "run.threads",
                                        "run.ranks",
                                        "run.device",
                                        "run.checkpoint",
                                        "fvm.openfoam",
                                        "sampling.snapshots",
                                        "refine.name",
                                        "ply.name",
                                        "gauge.body",
                                        "run.stop",
                                        "wave.empty_twin",
                                        "wave.calm_twin",
                                        "measured.quantity",
                                        "measured.value",
                                        "measured.uncertainty",
                                        "measured.source",
                                        "measured.speed",
                                        "measured.wave_length"},
        beginning{"motion.ramp", "hull.release"};
    for (const SceneKey& key : scene_keys()) {
        const std::string name = key.section + "." + key.name;
        const auto expected = in_none.contains(name)                                 ? SceneKey::Hashed::nowhere
                              : find_method(key.section) || beginning.contains(name) ? SceneKey::Hashed::run
                                                                                     : SceneKey::Hashed::scene;
        EXPECT_EQ(key.hashed, expected) << name;
    }
}

TEST(Keys, EachIsInTheTableOnceWithASentenceAndADefault) {
    std::set<std::string> seen, sections;
    for (const SectionRow& s : scene_sections()) sections.insert(s.name);
    for (const SceneKey& key : scene_keys()) {
        EXPECT_TRUE(seen.insert(key.section + "." + key.name).second) << key.name;
        EXPECT_TRUE(sections.contains(key.section)) << key.name;
        EXPECT_TRUE(key.meaning.ends_with(".")) << key.section << " " << key.name;
        EXPECT_FALSE(fallback_text(key).empty()) << key.section << " " << key.name;
    }
    EXPECT_THROW(scene_key("sph", "dleta"), std::logic_error);
}

TEST(Keys, RangesSayWhatIsRefused) {
    EXPECT_EQ(range_text({0, 1, true}, "-"), "greater than 0 and at most 1");
    EXPECT_EQ(range_text({0, 1}, "m"), "from 0 m to 1 m");
    EXPECT_EQ(range_text(positive, "s"), "greater than 0 s");
    EXPECT_EQ(range_text(not_negative, "s"), "at least 0 s");
    EXPECT_EQ(range_text(any_value, "s"), "");
    EXPECT_NE(
        complaint(planing + "[sph]\ncfl = 0\n").find("cfl = 0: out of range; expected greater than 0 and at most 1"),
        std::string::npos);
}

TEST(Keys, TheCommittedReferenceIsTheGeneratedOne) {
    EXPECT_EQ(read_text(std::filesystem::path(TWINWAKE_SOURCE) / "docs" / "scene_reference.md"), scene_reference())
        << "run: twinwake reference --out docs/scene_reference.md";
}

SceneOverrides scaled(double scale) {
    SceneOverrides o;
    o.scale_resolution = scale;
    return o;
}

TEST(FamilyHash, IsTheSameAtEverySizeOfOneScene) {
    const std::string low_speed =
        "[hull]\nshape = 'wigley'\ndraft = 0.15625\nhalf = true\n[motion]\nspeed = 1.5\n[resolution]\nnear_hull = "
        "0.02\n";
    const std::string channel =
        "[motion]\nkind = 'stream'\nspeed = 2\n[domain]\nx = [-1.03, 2.01]\nz = [-0.52, 0.6]\ndimensions = 2\n"
        "[resolution]\nnear_hull = 0.05\n";
    for (const std::string& text : {planing, tank, tank + "[domain]\ndimensions = 2\n", low_speed, channel}) {
        const Scene base = scene_of(text);
        for (const double scale : {0.5, 0.70711, 1.41421, 2.0})
            for (const char* method : {"sph", "fvm"}) {
                const Scene other = scene_of(text, scaled(scale));
                EXPECT_EQ(family_hash(base, method), family_hash(other, method)) << scale << text;
                EXPECT_NE(run_hash(base, method), run_hash(other, method)) << scale << text;
            }
    }
    SceneOverrides near;
    near.near_hull = 0.04;
    EXPECT_EQ(family_hash(scene_of(planing), "sph"), family_hash(scene_of(planing, near), "sph"));
}

TEST(FamilyHash, SeesTheVariationsOfAGridStudy) {
    SceneOverrides sound, step, courant;
    sound.sound_speed_factor = 1.5;
    step.time_step_factor = courant.courant_factor = 0.5;
    const Scene base = scene_of(planing);
    EXPECT_NE(family_hash(base, "sph"), family_hash(scene_of(planing, sound), "sph"));
    EXPECT_NE(family_hash(base, "sph"), family_hash(scene_of(planing, step), "sph"));
    EXPECT_NE(family_hash(base, "fvm"), family_hash(scene_of(planing, courant), "fvm"));
    EXPECT_EQ(family_hash(base, "fvm"), family_hash(scene_of(planing, step), "fvm"));
    EXPECT_NE(family_hash(base, "sph"), family_hash(base, "fvm"));
}

}  // namespace keys_test
}  // namespace tw::test

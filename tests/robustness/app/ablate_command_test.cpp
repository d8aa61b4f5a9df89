#include <algorithm>
#include <nlohmann/json.hpp>

#include "program.h"

namespace tw::test {
namespace ablate_command_test {

using nlohmann::json;

class AblateCommand : public Command {};

// Some 400 particles of water that fall in a flat tank, with a probe where they arrive.
const std::string column = R"(title = "falling <column>"
[tank]
size = [0.4, 0.02, 0.4]
[domain]
dimensions = 2
[[water_block]]
min = [0, 0, 0]
max = [0.2, 0.02, 0.2]
[resolution]
near_hull = 0.01
[run]
duration = 0.2
threads = 1
methods = ["sph"]
[[probe]]
name = "floor"
pressure = [0.1, 0.01, 0]
)";

json run_named(const json& facts, const std::string& name) {
    for (const json& r : facts["runs"])
        if (r["name"].get<std::string>().starts_with(name)) return r;
    return nullptr;
}

TEST_F(AblateCommand, EffectsAreSwitchedAndTabulatedAndReused) {
    write("column.toml", column);
    const std::vector<std::string> command{"ablate",  "column.toml", "--json",  "facts.json",     "--effects",
                                           "gravity", "shifting",    "no_slip", "compressibility"};
    const Outcome o = twinwake(command);
    ASSERT_EQ(o.status, 0) << o.err << o.out;
    const fs::path out = folder_ / "runs/column_ablation";
    for (const char* file : {"ablation.md", "ablation.json", "ablation.csv", "ablation.html"})
        EXPECT_TRUE(fs::exists(out / file)) << file;
    const json facts = json::parse(content(folder_ / "facts.json"));
    // base, viscosity for no_slip's sake, and the four that were asked for, in the plan's order
    ASSERT_EQ(facts["runs"].size(), 6u) << facts.dump(1);
    EXPECT_EQ(facts["runs"][0]["name"], "base");
    EXPECT_EQ(facts["runs"][1]["effect"], "viscosity");
    const json no_slip = run_named(facts, "no_slip off");  // on with viscosity, off without
    EXPECT_EQ(no_slip["against"], facts["runs"][1]["name"]);
    EXPECT_EQ(no_slip["why_not"], "");
    EXPECT_NE(
        run_named(facts, "compressibility")["why_not"].get<std::string>().find("solved as (nearly) incompressible"),
        std::string::npos);
    EXPECT_FALSE(fs::exists(out / "compressibility_on"));
    // Weightless water does not fall: the pressure on the floor is gone.
    const auto& changes = facts["changes"];
    const auto floor = std::ranges::find_if(
        changes, [](const json& c) { return c["run"] == "gravity off" && c["quantity"] == "pressure:floor"; });
    ASSERT_NE(floor, changes.end()) << facts.dump(1);
    EXPECT_GT((*floor)["before"].get<double>(), 500);  // 9.81 x 0.2 m of water is 1962 Pa
    EXPECT_LT((*floor)["per_cent"].get<double>(), -90);
    EXPECT_EQ((*floor)["seen"], "no interval");
    for (const json& c : facts["costs"]) EXPECT_GT(c["processor_seconds_per_second_after"].get<double>(), 0);
    EXPECT_EQ(content(out / "ablation.html").find("<column>"), std::string::npos);

    const std::string record = content(out / "gravity_off/sph/record.h5");
    ASSERT_FALSE(record.empty());
    const Outcome again = twinwake(command);
    EXPECT_EQ(again.status, 0) << again.err;
    EXPECT_NE(again.out.find("gravity off: SPH: finished before, taken from"), std::string::npos) << again.out;
    EXPECT_TRUE(content(out / "gravity_off/sph/record.h5") == record);

    // Another base in the same folder is refused, not mixed in.
    const Outcome other = twinwake({"ablate", "column.toml", "--effects", "shifting", "--near-hull", "0.02"});
    EXPECT_EQ(other.status, 2) << other.out;
    EXPECT_NE(other.err.find("belongs to another scene"), std::string::npos) << other.err;
    EXPECT_TRUE(content(out / "gravity_off/sph/record.h5") == record);
}

TEST_F(AblateCommand, ARunThatCannotBeMadeDoesNotStopTheOthers) {
    write("column.toml", column);
    write("runs/column_ablation/gravity_off", "in the way");
    const Outcome o = twinwake({"ablate", "column.toml", "--json", "facts.json", "--effects", "gravity", "shifting"});
    EXPECT_EQ(o.status, 0) << o.err;
    const json facts = json::parse(content(folder_ / "facts.json"));
    EXPECT_NE(run_named(facts, "gravity off")["why_not"], "");
    EXPECT_EQ(run_named(facts, "shifting off")["why_not"], "");
    EXPECT_EQ(content(folder_ / "runs/column_ablation/gravity_off"), "in the way");
}

// Air needs particles of one size: switched, it would be compared with water of several.
TEST_F(AblateCommand, AnEffectThatTakesOtherSizesWithItIsNotOneEffect) {
    const std::string post = "[[obstacle]]\nmin = [1.4, 0, 0]\nmax = [1.5, 0.02, 0.2]\n";
    std::string text = with(with(column, "[0.4, 0.02, 0.4]", "[2, 0.02, 0.8]"), "[[probe]]", post + "[[probe]]");
    write("post.toml", with(text, "near_hull = 0.01", "near_hull = 0.01\nspacing = 0.02"));
    const Outcome o = twinwake({"ablate", "post.toml", "--effects", "air"});
    EXPECT_EQ(o.status, 2);
    EXPECT_NE(o.err.find("air: cannot be switched alone: it takes other sizes of particles"), std::string::npos)
        << o.err;
    EXPECT_FALSE(fs::exists(folder_ / "runs"));
}

TEST_F(AblateCommand, StoppedItContinuesFromThere) {
    write("column.toml", with(column, "duration = 0.2", "duration = 6\ncheckpoint = 0.05"));
    const std::vector<std::string> command{"ablate", "column.toml", "--effects", "shifting"};
    const Started s = start(command);
    const fs::path saved = folder_ / "runs/column_ablation/base/sph/checkpoint.h5";
    for (int k = 0; k < 2400 && !fs::exists(saved); ++k) usleep(50000);
    ASSERT_TRUE(fs::exists(saved));
    kill(s.child, SIGINT);
    const Outcome stopped = finish(s);
    EXPECT_EQ(stopped.status, 3);
    EXPECT_NE(stopped.err.find("the same command continues from here"), std::string::npos) << stopped.err;
    EXPECT_FALSE(fs::exists(folder_ / "runs/column_ablation/ablation.html"));
    std::vector<std::string> shorter = command;
    shorter.insert(shorter.end(), {"--duration", "0.3"});  // the length of a run is not part of its identity
    const Outcome o = twinwake(shorter);
    EXPECT_EQ(o.status, 0) << o.err;
    EXPECT_TRUE(fs::exists(folder_ / "runs/column_ablation/ablation.html"));
}

TEST_F(AblateCommand, WrongArgumentsAreRefusedBeforeTheWorkAndLeaveNothing) {
    EXPECT_EQ(twinwake({"ablate", "--help"}).status, 0);
    write("column.toml", column);
    const auto refused = [&](const std::vector<std::string>& arguments) {
        std::vector<std::string> all{"ablate", "column.toml"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        const Outcome o = twinwake(all);
        EXPECT_EQ(o.status, 2) << o.err;
        EXPECT_EQ(o.out.find("runs, about"), std::string::npos) << o.out;
        return o.err;
    };
    EXPECT_EQ(refused({"--effects", "surface_tensoin"}),
              "--effects surface_tensoin: there is no effect 'surface_tensoin'; expected one of: viscosity, friction, "
              "no_slip, "
              "turbulence, surface_tension, air, compressibility, gravity, ventilation, cavitation, forcing_zones, "
              "acoustic_damping, shifting, tension_control, dynamic_pressure; did you mean 'surface_tension'?\n");
    EXPECT_NE(refused({"--effects", "compressibility"})
                  .find("none of these effects can be switched; compressibility: cannot be switched: "),
              std::string::npos);
    EXPECT_NE(refused({"--effects", "shifting", "--method", "fvm"}).find("it acts in the particle method alone"),
              std::string::npos);
    refused({"--method", "dns"});
    refused({"--threads", "0"});
    refused({"--effects"});
    EXPECT_EQ(twinwake({"ablate", "absent.toml"}).status, 2);
    EXPECT_EQ(twinwake({"ablate"}).status, 2);
    EXPECT_EQ(files(), std::set<std::string>{"column.toml"});
}

TEST_F(AblateCommand, AnEffectIsSaidOnTheCommandLineOfAnyScene) {
    write("a.toml", planing);
    const auto state = [&](const std::vector<std::string>& arguments, const std::string& name) {
        std::vector<std::string> all{"check"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        all.insert(all.end(), {"--json", "-"});
        const Outcome o = twinwake(all);
        EXPECT_EQ(o.status, 0) << o.err;
        const json facts = json::parse(o.out);
        for (const json& e : facts["effects"])
            if (e["name"] == name) return e["on"].get<bool>();
        ADD_FAILURE() << name;
        return false;
    };
    EXPECT_TRUE(state({"a.toml"}, "shifting"));
    EXPECT_FALSE(state({"a.toml", "--effect", "shifting=off"}, "shifting"));
    EXPECT_FALSE(state({"a.toml"}, "turbulence"));
    EXPECT_TRUE(state({"--effect", "viscosity=on", "--effect", "shifting=off", "a.toml"}, "turbulence"));  // follows
    write("off.toml", planing + "[effects]\nsurface_tension = \"off\"\n");
    EXPECT_TRUE(state({"off.toml", "--effect", "surface_tension=on"}, "surface_tension"));

    EXPECT_EQ(twinwake({"check", "a.toml", "--effect", "shifting"}).err,
              "--effect shifting: expected shifting=on or shifting=off\n");
    EXPECT_EQ(twinwake({"run", "a.toml", "--effect", "shifting=maybe"}).err,
              "--effect shifting=maybe: expected shifting=on or shifting=off\n");
    const Outcome unknown = twinwake({"ladder", "a.toml", "--effect", "viscosty=on"});
    EXPECT_EQ(unknown.status, 2);
    EXPECT_EQ(unknown.err.substr(0, 62), "--effect viscosty=on: there is no effect 'viscosty'; expected ");
    EXPECT_NE(unknown.err.find("did you mean 'viscosity'?"), std::string::npos) << unknown.err;
    const Outcome needs = twinwake({"check", "a.toml", "--effect", "no_slip=on"});
    EXPECT_EQ(needs.status, 2);
    EXPECT_NE(needs.err.find("--effect no_slip"), std::string::npos) << needs.err;
    EXPECT_NE(needs.err.find("needs viscosity"), std::string::npos) << needs.err;
}

}  // namespace ablate_command_test
}  // namespace tw::test

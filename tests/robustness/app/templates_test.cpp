// The scenes of `twinwake new`, run: a newcomer's first report must not begin with checks that its scene does not meet.

#include "program.h"
#include "record/run_record.h"

namespace tw::test {
namespace templates_test {

struct Coarse {
    const char* name;
    const char* scale;     ///< of the template's sizes
    const char* duration;  ///< includes what strains the checks: a front at a wall, an impact, the start of a stream
    std::set<std::string> missed = {};
};
/// Of a hull in a stream the zones of finer particles gain and lose mass while the stream starts: a warning only, which
/// no template can avoid (docs/results/fridsma.md: 1 % at b/14, limit 0.5 %). At four times its sizes the zones of one
/// have half as many spacings, and spray across their edges makes orphans: a warning as well.
const Coarse all[] = {
    {"tank", "1.4142", "0.4 s"},
    {"body", "2", "0.15 s"},
    {"waves", "2", "1.5 s"},
    {"planing", "3", "0.3 s", {"mass drift of a finer zone"}},
    {"seaplane", "4", "0.5 s", {"mass drift of a finer zone", "orphans at a zone's edge"}},
};

class Template : public Command, public testing::WithParamInterface<Coarse> {};

TEST_P(Template, MeetsItsOwnChecks) {
    const Coarse& coarse = GetParam();
    const std::string file = std::string(coarse.name) + ".toml";
    ASSERT_EQ(twinwake({"new", coarse.name, file}).status, 0);
    const Outcome o = twinwake({"run", file, "--method", "sph", "--no-twins", "--scale", coarse.scale, "--duration",
                                coarse.duration, "--threads", "1", "--quiet", "--out", "out"});
    ASSERT_EQ(o.status, 0) << o.err;
    const RunRecord record = read_record(folder_ / "out/sph/record.h5");
    ASSERT_FALSE(record.validity_checks.empty());
    for (const RecordedCheck& line : record.validity_checks)
        EXPECT_TRUE(line.value <= line.limit || coarse.missed.contains(line.name))
            << line.name << ": " << line.value << ", limit " << line.limit;
}

INSTANTIATE_TEST_SUITE_P(New, Template, testing::ValuesIn(all),
                         [](const auto& row) { return std::string(row.param.name); });

}  // namespace templates_test
}  // namespace tw::test

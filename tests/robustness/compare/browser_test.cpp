// The report in a real browser (Chromium, where it is installed): its scripts are allowed to run, draw plots and view
// and complain of nothing. In a build without npm there are none.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "base/atomic_file.h"
#include "compare/compare.h"
#include "compare/report/page.h"
#include "tests/unit/compare/synthetic_pair.h"
#include "tests/unit/record/example_record.h"

namespace tw {
namespace browser_test {

bool installed() { return std::system("command -v chromium > /dev/null 2>&1") == 0; }

/// The page after its script has run, as markup, and what the browser logged of it. `page`: a path without quotes.
/// `ms`: after this time of the page's own clock, which stands still while a script runs. A browser that hangs, as it does
/// now and then on a busy machine, is started once more.
std::pair<std::string, std::string> opened(const std::filesystem::path& page, const std::filesystem::path& profile,
                                           int ms) {
    const std::filesystem::path log = profile.string() + ".log";
    const std::string command =
        "timeout 240 chromium --headless=new --no-sandbox --user-data-dir='" + profile.string() +
        "' --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader --enable-logging=stderr "
        "--window-size=1400,900 --virtual-time-budget=" +
        std::to_string(ms) + " --dump-dom 'file://" + page.string() + "' 2> '" + log.string() + "'";
    std::string markup;
    for (int start = 0; start < 2 && markup.empty(); ++start) {
        std::filesystem::remove_all(profile);
        std::array<char, 65536> part;
        FILE* pipe = popen(command.c_str(), "r");
        if (!pipe) return {};
        while (const std::size_t n = std::fread(part.data(), 1, part.size(), pipe)) markup.append(part.data(), n);
        pclose(pipe);
    }
    return {markup, read_text(log)};
}

/// In place of what comes with the browser's frames, which a busy machine hardly has while the browser's clock runs on:
/// what waits for a frame is done in one task, and what comes near the screen is looked for twenty times a second.
constexpr const char* without_frames = R"(
    const drawings = [];
    window.requestAnimationFrame = draw => {
        if (drawings.push(draw) === 1) setTimeout(() => drawings.splice(0).forEach(draw => draw(performance.now())));
        return 1;
    };
    window.IntersectionObserver = class {
        constructor(tell, {rootMargin}) {
            this.watched = new Set();
            setInterval(() => {
                const near = Array.from(this.watched).filter(element => {
                    const {top, bottom, width} = element.getBoundingClientRect(), reach = parseFloat(rootMargin);
                    return width > 0 && top < innerHeight + reach && bottom > -reach;
                });
                if (near.length > 0) tell(near.map(target => ({target, isIntersecting: true})), this);
            }, 50);
        }
        observe(element) { this.watched.add(element); }
        unobserve(element) { this.watched.delete(element); }
        disconnect() { this.watched.clear(); }
    };)";

/// The page with one more script at its end, which its policy then allows, and without the browser's frames.
std::filesystem::path with_script(const std::filesystem::path& page, const std::string& script) {
    std::string text = read_text(page);
    const std::string policy = "style-src 'unsafe-inline'", others = "; script-src ";
    const std::string both = script_source(script) + " " + script_source(without_frames);
    const std::size_t at = text.find(policy) + policy.size();
    if (text.compare(at, others.size(), others) == 0)
        text.insert(at + others.size(), both + " ");
    else
        text.insert(at, others + both);
    text.insert(text.find("</main></body>"), "<script>" + script + "</script>");
    text.insert(text.find("</head>"), "<script>" + std::string(without_frames) + "</script>");
    const std::filesystem::path probed = page.parent_path() / "probed.html";
    write_text_atomically(probed, text);
    return probed;
}

/// What the script left in the body's data-NAME.
std::string left(const std::string& markup, const std::string& name) {
    const std::string begin = "data-" + name + "=\"";
    const auto at = markup.find(begin);
    return at == std::string::npos
               ? ""
               : markup.substr(at + begin.size(), markup.find('"', at + begin.size()) - at - begin.size());
}

/// The number behind a word; nan where the word is not there.
double number_after(const std::string& text, const std::string& word) {
    const auto at = text.find(word);
    return at == std::string::npos ? std::nan("") : std::stod(text.substr(at + word.size()));
}

const std::string until = R"(
    const until = async there => {
        for (let k = 0; k < 200 && !there(); ++k) await new Promise(then => setTimeout(then, 20));
    };)";

/// Scrolls to the view once the page is there, and says what its clock shows before and after; then `more` is done.
std::string at_the_view(const std::string& more) {
    return until + R"(
    addEventListener('load', () => setTimeout(async () => {
        const answer = document.body.dataset, clock = () => document.getElementById('view3d-clock').textContent;
        answer.before = clock();
        document.querySelector('section.view3d').scrollIntoView();
        await until(clock);
        answer.after = clock();
        )" +
           more + "}, 300));";
}

// Offline and under the page's own policy, when it comes near; and whether colours of the pressure scale, which no
// height has, are in the picture.
TEST(Browser, TheReportsViewRunsOfflineAndColoursTheHullByPressureWhereThereIsOne) {
    if (!installed()) GTEST_SKIP() << "no chromium here";
    if (!*view3d_script) GTEST_SKIP() << "a build without npm";
    const ScratchFolder folder;
    std::vector<RunRecord> records{synthetic_run({}), synthetic_run({.method = "fvm", .lift = 2600})};
    for (RunRecord& r : records) {  // two fifths of the scale nearly everywhere: magenta
        float pressure = 4000;
        for (std::size_t t = 0; t < r.hull_pressure.size(); ++t)
            if (r.hull_wet[t] > 0) r.hull_pressure[t] = std::exchange(pressure, 1600.0f);
    }
    const Comparison c = compare_records(std::move(records));
    const auto page = with_script(write_report(c, folder.path()).html, at_the_view(R"(
        const canvas = document.getElementById('view3d-canvas'), choice = document.getElementById('view3d-colour');
        const copy = document.createElement('canvas'), of = id => document.getElementById('view3d-' + id);
        const magenta = async colour => {
            choice.value = colour;
            choice.dispatchEvent(new Event('change'));
            const pen = copy.getContext('2d');
            await new Promise(then => requestAnimationFrame(() => {  // behind the view's own
                copy.width = canvas.width, copy.height = canvas.height;
                pen.drawImage(canvas, 0, 0);
                then();
            }));
            const [left, right] = [0, copy.width / 2].map(x => {
                const {data} = pen.getImageData(x, 0, copy.width / 2, copy.height);
                let count = 0;
                for (let i = 0; i < data.length; i += 4)
                    if (data[i] > 110 && data[i] < 200 && data[i + 1] < 70 && data[i + 2] > 60) ++count;
                return count;
            });
            return left + ' ' + right + ' ' + [of('pressure').hidden, of('legend').hidden, of('layout').disabled];
        };
        answer.pressure = await magenta('pressure');
        answer.height = await magenta('height');)"));
    const auto [markup, log] = opened(page, folder / "profile", 4000);
    EXPECT_EQ(left(markup, "before"), "") << "a drawing context takes long, and nobody has asked for it";
    EXPECT_EQ(left(markup, "after").substr(0, 4), "t = ") << log;
    EXPECT_NE(markup.find("<div id=\"view3d-stage\">"), std::string::npos) << log;  // no longer hidden
    EXPECT_NE(markup.find("id=\"view3d-fallback\" hidden"), std::string::npos);
    const std::string pressure = left(markup, "pressure"), height = left(markup, "height");
    ASSERT_FALSE(pressure.empty()) << log;
    EXPECT_GT(number_after(pressure, ""), 500) << pressure << " on the left hull";
    EXPECT_GT(number_after(pressure, " "), 500) << pressure << " on the right hull";
    EXPECT_LT(number_after(height, ""), 50) << height;
    EXPECT_TRUE(pressure.ends_with("false,true,true")) << pressure;
    EXPECT_TRUE(height.ends_with("true,false,false")) << height;
    EXPECT_EQ(log.find("Uncaught"), std::string::npos) << log;
    EXPECT_EQ(log.find("Content Security Policy"), std::string::npos) << log;
    EXPECT_EQ(log.find("INVALID_"), std::string::npos) << log;  // what WebGL says of wrong calls
}

// 1400 x 900: who opens the page reads the answer, sees the water and what speaks against it before scrolling.
TEST(Browser, TheFirstScreenHoldsAnswerPicturesAndTrust) {
    if (!installed()) GTEST_SKIP() << "no chromium here";
    const ScratchFolder folder;
    std::vector<RunRecord> records{synthetic_run({}), synthetic_run({.method = "fvm", .lift = 2600})};
    for (RunRecord& r : records)
        r.attributes["box_walls"] =
            "the walls of the box (1.5 m to the side, 1.25 m deep) are expected to raise the lift by 12 %; 3 m to the "
            "side and 2.5 m deep would leave 2 %";
    const Comparison c = compare_records(std::move(records));
    const auto page = with_script(write_report(c, folder.path()).html, R"(addEventListener('load', () => {
        const bottom = what => Math.max(...Array.from(document.querySelectorAll(what), e => e.getBoundingClientRect().bottom));
        Object.assign(document.body.dataset, {width: innerWidth, answer: bottom('.verdict'), strip: bottom('svg.strip'),
            picture: bottom('.shots img, .shots + svg'), trust: bottom('details.line'), next: bottom('.next')});
    });)");
    const auto [markup, log] = opened(page, folder / "profile", 600);
    EXPECT_NEAR(number_after(left(markup, "width"), ""), 1400, 20);
    for (const char* part : {"answer", "strip", "picture", "trust", "next"}) {
        const std::string bottom = left(markup, part);
        ASSERT_FALSE(bottom.empty()) << part << log;
        EXPECT_GT(number_after(bottom, ""), 100) << part;
        EXPECT_LT(number_after(bottom, ""), 900) << part;
    }
}

// Which of its values each curve has at the pointer, in the whole plot, in a part of it, and in the whole again; then
// what the keys say to who does not see it.
TEST(Browser, PlotsTellTheirValuesAndZoom) {
    if (!installed()) GTEST_SKIP() << "no chromium here";
    if (!*plots_script) GTEST_SKIP() << "a build without npm";
    const ScratchFolder folder;
    const Comparison c = compare_records({synthetic_run({}), synthetic_run({.method = "fvm", .lift = 2600})});
    const auto page = with_script(write_report(c, folder.path()).html,
                                  until + R"(addEventListener('load', () => setTimeout(async () => {
        await until(() => document.querySelector('.plot-live'));
        const live = Array.from(document.querySelectorAll('.plot-live')).find(e => e.textContent.startsWith('Lift'));
        const box = live.querySelector('.plot-box'), over = live.querySelector('.u-over');
        const drawn = () => new Promise(then => setTimeout(then, 100));
        const mouse = (kind, share) => {
            const at = over.getBoundingClientRect();
            over.dispatchEvent(new MouseEvent(kind, {clientX: at.left + share * at.width, clientY: at.top + at.height / 2,
                movementX: 1, bubbles: true}));
        };
        const told = async share => {
            mouse('mousemove', share);
            await drawn();
            const rows = Array.from(live.querySelectorAll('.u-series')).filter(row => row.getClientRects().length > 0);
            return rows.map(row => row.querySelector('.u-label').textContent + ': ' + row.querySelector('.u-value').textContent).join(', ');
        };
        const answer = document.body.dataset;
        mouse('mouseenter', 0.5);
        answer.whole = await told(0.75);
        mouse('mousedown', 0.25);
        mouse('mousemove', 0.5);
        mouse('mouseup', 0.5);
        await drawn();
        answer.part = await told(0.5);
        mouse('dblclick', 0.5);
        await drawn();
        answer.again = await told(0.75);
        box.dispatchEvent(new KeyboardEvent('keydown', {key: 'ArrowLeft', bubbles: true}));
        answer.said = live.querySelector('[aria-live]').textContent;
        answer.name = box.getAttribute('aria-label');
        answer.drawing = getComputedStyle(live.parentElement.querySelector('svg.plot')).display;
        const key = live.querySelector('.u-legend th[role=switch]');
        const press = async () => {
            key.dispatchEvent(new KeyboardEvent('keydown', {key: 'Enter', bubbles: true}));
            await drawn();
            return key.textContent + ' ' + key.getAttribute('aria-checked');
        };
        answer.hidden = await press();
        answer.back = await press();
    }, 500));)");
    const auto [markup, log] = opened(page, folder / "profile", 3500);
    const std::string whole = left(markup, "whole"), part = left(markup, "part"), said = left(markup, "said");
    EXPECT_NEAR(number_after(whole, "time [s]: "), 1.5, 0.02) << whole << log;
    EXPECT_NEAR(number_after(whole, "SPH: "), 2800, 100) << whole;  // two and a half times the scatter of the series
    EXPECT_NEAR(number_after(whole, "interFoam: "), 2600, 100) << whole;
    EXPECT_EQ(whole.find("Value"), std::string::npos) << "the pale raw traces have no row: " << whole;
    EXPECT_NEAR(number_after(part, "time [s]: "), 0.75, 0.02) << part;
    EXPECT_EQ(left(markup, "again"), whole);
    EXPECT_NEAR(number_after(said, "time [s]: "), 1.48, 0.02) << said;
    EXPECT_NEAR(number_after(said, "interFoam: "), 2600, 100) << said;
    EXPECT_EQ(left(markup, "name").substr(0, 4), "Lift");
    EXPECT_EQ(left(markup, "drawing"), "none") << "it is for paper";
    EXPECT_EQ(left(markup, "hidden"), "SPH false");
    EXPECT_EQ(left(markup, "back"), "SPH true");
    EXPECT_EQ(log.find("Uncaught"), std::string::npos) << log;
    EXPECT_EQ(log.find("Content Security Policy"), std::string::npos) << log;
}

// The labels along x of a plot, in parts of it of many widths: equal steps on the screen are equal steps of the
// numbers, which labels with too few digits are not (0, 0.03, 0.05, 0.08 for 0.025, 0.05, 0.075).
TEST(Browser, TheTicksOfPlotsSayWhereTheyStand) {
    if (!installed()) GTEST_SKIP() << "no chromium here";
    if (!*plots_script) GTEST_SKIP() << "a build without npm";
    const ScratchFolder folder;
    const Comparison c = compare_records({synthetic_run({}), synthetic_run({.method = "fvm", .lift = 2600})});
    const auto page = with_script(write_report(c, folder.path()).html, until + R"(
    const written = [], write = CanvasRenderingContext2D.prototype.fillText;
    CanvasRenderingContext2D.prototype.fillText = function (text, x, y) {
        written.push({canvas: this.canvas, number: Number(text.replace('\u2212', '-')), x, y});
        write.apply(this, arguments);
    };
    addEventListener('load', () => setTimeout(async () => {
        await until(() => document.querySelector('.plot-live'));
        const live = Array.from(document.querySelectorAll('.plot-live')).find(e => e.textContent.startsWith('Lift'));
        const over = live.querySelector('.u-over'), canvas = live.querySelector('canvas');
        const mouse = (kind, share) => {
            const at = over.getBoundingClientRect();
            over.dispatchEvent(new MouseEvent(kind, {clientX: at.left + share * at.width, clientY: at.top + at.height / 2,
                movementX: 1, bubbles: true}));
        };
        const drawn = () => new Promise(then => setTimeout(then, 100));
        let steps = 0, quarters = 0, wrong = '';
        for (const share of [0.9, 0.6, 0.45, 0.3, 0.2, 0.17, 0.15, 0.135, 0.12, 0.11, 0.1, 0.085]) {
            mouse('dblclick', 0.5);
            await drawn();
            written.length = 0;
            mouse('mousedown', 0.05);
            mouse('mousemove', 0.05 + share);
            mouse('mouseup', 0.05 + share);
            await drawn();
            const here = written.filter(w => w.canvas === canvas && Number.isFinite(w.number));
            const row = Math.max(...here.map(w => w.y));
            const ticks = here.filter(w => w.y === row).sort((a, b) => a.x - b.x);
            const across = (ticks.at(-1).x - ticks[0].x) / (ticks.length - 1);
            const step = (ticks.at(-1).number - ticks[0].number) / (ticks.length - 1);
            if (ticks.some((t, i) => Math.abs(t.number - ticks[0].number - step * (t.x - ticks[0].x) / across) > 0.1 * step))
                wrong += ticks.map(t => t.number).join(' ') + '; ';
            ++steps;
            if (String(Math.round(step * 1e6)).startsWith('25')) ++quarters;
        }
        Object.assign(document.body.dataset, {steps, quarters, wrong});
    }, 500));)");
    const auto [markup, log] = opened(page, folder / "profile", 4500);
    EXPECT_EQ(left(markup, "steps"), "12") << log;
    EXPECT_GE(number_after(left(markup, "quarters"), ""), 1) << "of steps that need one digit more";
    EXPECT_EQ(left(markup, "wrong"), "");
}

// Shaders, too, are compiled there alone: a body on its way through the water, with the water cut open.
TEST(Browser, TheViewDrawsABodyThatMovesAndOffersToCutTheWaterOpen) {
    if (!installed()) GTEST_SKIP() << "no chromium here";
    if (!*view3d_script) GTEST_SKIP() << "a build without npm";
    RunRecord r = synthetic_run({});
    r.bodies.push_back({"body_buoy", r.hull, Vec3::Zero()});
    r.attributes["motion"] = "none";
    r.hull = {};
    r.hull_pressure.clear();
    r.hull_wet.clear();
    Table& t = r.table("body_buoy");
    for (const double time : {0.0, 2.0}) {
        t.time.push_back(time);
        for (const char* column : {"x", "y", "z", "qx", "qy", "qz"}) t.column(column, "").values.push_back(0.1 * time);
        t.column("q0", "-").values.push_back(1);
    }
    const ScratchFolder folder;
    const auto page = with_script(write_report(compare_records({r}), folder.path()).html, at_the_view(""));
    const auto [markup, log] = opened(page, folder / "profile", 2500);
    EXPECT_EQ(left(markup, "after").substr(0, 4), "t = ") << log;
    EXPECT_NE(markup.find("water cut open</label>"), std::string::npos);
    EXPECT_NE(markup.find("bodies</label>"), std::string::npos);
    EXPECT_EQ(log.find("Uncaught"), std::string::npos) << log;
    EXPECT_EQ(log.find("INVALID_"), std::string::npos) << log;  // what WebGL says of wrong calls
}

}  // namespace browser_test
}  // namespace tw

#include "compare/report/page.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/sha256.h"

namespace tw {

const char* const report_style = R"(
:root{color-scheme:light dark;--bg:#fff;--text:#1b1f24;--soft:#5b6470;--line:#d8dde3;--panel:#f5f7f9;--s0:#1f62b5;--s1:#c8501c;--s2:#2a8a4a;--s3:#8447b5;
--good:#1d7a3a;--goodbg:#e2f4e7;--bad:#b02a1b;--badbg:#fbe7e3;--open:#8a5a00;--openbg:#fdf1d6;--none:#5b6470;--nonebg:#eceff2}
@media (prefers-color-scheme:dark){:root{--bg:#14171b;--text:#e4e8ec;--soft:#9aa4af;--line:#343b43;--panel:#1c2126;--s0:#6aa8f0;--s1:#f0905a;--s2:#63c585;--s3:#bf92ea;
--good:#7ad695;--goodbg:#173322;--bad:#f59a8c;--badbg:#3b1c17;--open:#efc36b;--openbg:#3a2d10;--none:#9aa4af;--nonebg:#262c32}}
*{box-sizing:border-box}
body{margin:0;background:var(--bg);color:var(--text);font:15px/1.5 system-ui,-apple-system,"Segoe UI",Roboto,"DejaVu Sans",sans-serif}
main{max-width:1340px;margin:0 auto;padding:14px 24px 60px}
h1{font-size:23px;line-height:1.2;margin:0 0 2px}h2{font-size:18px;margin:38px 0 10px;padding-bottom:5px;border-bottom:1px solid var(--line)}
h3{font-size:15px;margin:22px 0 6px}p{margin:6px 0}.sub{color:var(--soft);margin:0 0 10px}
.first{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,480px),1fr));gap:0 28px}.first h2{font-size:15px;margin:10px 0 4px;padding-bottom:2px}
.verdict{background:var(--panel);border-left:5px solid var(--s0);padding:4px 14px;border-radius:4px}.verdict p{font-size:15px;line-height:1.35;margin:2px 0}.verdict p.note{font-size:13.5px}
.answer{padding:5px 0}.answer+.answer{border-top:1px solid var(--line)}
.shots{display:grid;grid-template-columns:repeat(2,1fr);gap:10px}.shots figcaption{margin:0 0 2px}
.line{margin:3px 0;font-size:13.5px}.line summary{color:var(--text);padding:1px 8px;border-left:4px solid var(--open);background:var(--openbg);border-radius:3px}.line.bad summary{border-color:var(--bad);background:var(--badbg)}
.line summary{position:relative;padding-left:28px;list-style:none}.line summary::-webkit-details-marker{display:none}.line:not([open]) summary{display:-webkit-box;-webkit-box-orient:vertical;-webkit-line-clamp:3;overflow:hidden}
.icon{position:absolute;left:6px;top:3px;width:15px;height:15px;border-radius:8px;background:var(--open);color:var(--bg);font:700 12px/15px sans-serif;text-align:center}.bad .icon{background:var(--bad);border-radius:2px}
.said{padding:0 6px;border-radius:8px}.why{margin:0 0 2px}.beside{display:flex;flex-direction:column}.note sub{line-height:0}
@media(min-width:1000px){.line:not([open]) summary{-webkit-line-clamp:none}}
@media(max-width:700px){.seen{order:1}.todo{order:2}.line:not([open]) summary{-webkit-line-clamp:2}svg.strip:not(.narrow){display:none}svg.strip.narrow{display:block}}
.next{margin:0;padding-left:18px;font-size:14px}.next li{margin:2px 0}.next code{color:var(--soft);overflow-wrap:anywhere}
.fold>summary{color:var(--text);font-weight:600;font-size:15px;padding:5px 0;border-bottom:1px solid var(--line)}.fold[open]{margin-bottom:22px}
.note{color:var(--soft);font-size:13.5px}
.wide{overflow-x:auto}table{border-collapse:collapse;width:100%;font-size:14px}
th,td{text-align:left;padding:6px 10px;border-bottom:1px solid var(--line);vertical-align:top}th{font-weight:600;color:var(--soft);font-size:13px}
td.num,th.num{text-align:right;font-variant-numeric:tabular-nums}td.num{white-space:nowrap}td.text{overflow-wrap:anywhere}tr.ref td{color:var(--soft);font-style:italic}tr.remark td{color:var(--soft);font-size:13px;padding-top:0}
tr.has-remark td{border-bottom:0;padding-bottom:2px}
.badge{display:inline-block;padding:1px 9px;border-radius:10px;font-size:13px;font-weight:600;white-space:nowrap}
.agree{color:var(--good);background:var(--goodbg)}.differ{color:var(--bad);background:var(--badbg)}.undecided{color:var(--open);background:var(--openbg)}.not_converged{color:var(--open);background:var(--openbg)}.not_comparable{color:var(--none);background:var(--nonebg)}
.key{display:inline-block;width:11px;height:11px;border-radius:2px;margin-right:5px;vertical-align:-1px}.k0{background:var(--s0)}.k1{background:var(--s1)}.k2{background:var(--s2)}.k3{background:var(--s3)}
.multiples{display:grid;grid-auto-flow:column;grid-auto-columns:minmax(225px,1fr);gap:12px;overflow-x:auto;margin:10px 0}
.pair{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(100%,440px),1fr));gap:18px;margin:10px 0}
figure{margin:0}figcaption{font-size:13.5px;color:var(--soft);margin:4px 0}figure img{width:100%;height:auto;display:block;border:1px solid var(--line);border-radius:4px;background:#fff}
svg text{fill:var(--text);font:12px system-ui,-apple-system,"Segoe UI",Roboto,"DejaVu Sans",sans-serif}svg.plot{width:100%;height:auto;display:block}svg.scale{width:400px;max-width:100%;height:auto;display:block;margin:2px auto}
svg .plot-title{font-size:13.5px;font-weight:600}svg .tick{font-size:11px;fill:var(--soft)}svg .mid{text-anchor:middle}svg .end{text-anchor:end}
svg .frame{fill:none;stroke:var(--soft);stroke-width:1}svg .grid{stroke:var(--line);stroke-width:1}svg .line{fill:none;stroke-width:1.7;stroke-linejoin:round}
svg .faint{stroke-width:.8;opacity:.32}svg .dashed{stroke-dasharray:5 3}svg .mean{stroke-width:2.2}svg .band{opacity:.22}svg .level{stroke:var(--soft);stroke-dasharray:2 3}svg .level-text{fill:var(--soft);font-size:11px}
svg .outline{fill:none;stroke:var(--text);stroke-width:1.2}svg .box{fill-opacity:.08;stroke-width:1.4}svg .box.dashed{fill-opacity:0}svg .shadow{fill:none;stroke:var(--soft);opacity:.8}
svg.strip{width:100%;height:auto;display:block}svg.narrow{display:none}svg .bar{stroke-width:3}svg .outer{stroke-width:1}svg .apart{stroke:var(--text)}svg .dot{fill:var(--text)}svg .hollow{fill:var(--panel)}svg .value{font-size:12px;font-weight:600;font-variant-numeric:tabular-nums}svg .reference{stroke:var(--soft);stroke-width:1.6}svg .reference-band{fill:var(--soft);opacity:.16}
svg .box-text{font-size:11px;font-weight:600;paint-order:stroke;stroke:var(--bg);stroke-width:3px;stroke-linejoin:round}
svg .s0{stroke:var(--s0)}svg .s1{stroke:var(--s1)}svg .s2{stroke:var(--s2)}svg .s3{stroke:var(--s3)}svg .f0{fill:var(--s0)}svg .f1{fill:var(--s1)}svg .f2{fill:var(--s2)}svg .f3{fill:var(--s3)}
details{margin:8px 0}summary{cursor:pointer;color:var(--soft)}pre{background:var(--panel);padding:12px;border-radius:4px;overflow-x:auto;font-size:13px;line-height:1.4}code{font-family:ui-monospace,"DejaVu Sans Mono",monospace;font-size:.93em}
dl{display:grid;grid-template-columns:max-content 1fr;gap:2px 16px;font-size:14px}dt{color:var(--soft)}dd{margin:0;overflow-wrap:anywhere}
@media print{:root{color-scheme:light;--bg:#fff;--text:#000;--soft:#444;--line:#bbb;--panel:#f3f3f3;--s0:#1f62b5;--s1:#c8501c;--s2:#2a8a4a;--s3:#8447b5;--good:#1d7a3a;--goodbg:#e2f4e7;--bad:#b02a1b;--badbg:#fbe7e3;--open:#8a5a00;--openbg:#fdf1d6;--none:#444;--nonebg:#eee}
body{font-size:12px;-webkit-print-color-adjust:exact;print-color-adjust:exact}main{max-width:none;padding:0}h2{break-after:avoid}figure,tr,svg{break-inside:avoid}.pair{grid-template-columns:1fr 1fr}.multiples{grid-auto-flow:row;grid-template-columns:repeat(4,1fr)}.wide{overflow:visible}.first{grid-template-columns:1fr 1fr}.line:not([open]) summary{-webkit-line-clamp:none}details:not([open])>*{display:block}details::details-content{content-visibility:visible;height:auto}}
)";

std::string page_begin(const std::string& title, const std::string& style, const std::string& scripts) {
    return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
           "content=\"width=device-width, initial-scale=1\">"
           "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; base-uri 'none'; form-action "
           "'none'; img-src data:; style-src "
           "'unsafe-inline'" +
           (scripts.empty() ? "" : "; script-src " + scripts) + "\"><title>" + escaped(title) + "</title><style>" +
           report_style + style + "</style></head><body><main>";
}

std::string page_begin_with(const std::string& title, const std::string& facts) {
    return page_begin(title) + "<h1>" + escaped(title) + "</h1><p class=\"sub\">" + escaped(facts) + "</p>";
}

std::string script_source(const std::string& script) {
    const std::string hex = sha256_hex(script);
    std::string digest;
    for (std::size_t k = 0; k < hex.size(); k += 2)
        digest += static_cast<char>(std::stoi(hex.substr(k, 2), nullptr, 16));
    return "'sha256-" + base64(digest) + "'";
}

std::string script_data(const std::string& attributes, const nlohmann::ordered_json& data) {
    std::string text;
    for (const char c : data.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace))
        if (c == '<' || c == '>' || c == '&')
            text += fmt::format("\\u{:04x}", static_cast<int>(c));
        else
            text += c;
    return "<script type=\"application/json\" " + attributes + ">" + text + "</script>";
}

}  // namespace tw

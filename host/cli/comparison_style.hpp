// SPDX-License-Identifier: Apache-2.0
// The looks of the page of `cdsm compare`.
#pragma once

namespace cdsm::cli {

inline constexpr const char* kComparisonStyle = R"css(
:root { color-scheme: light dark; --page: #f6f7f9; --card: #ffffff; --text: #1b1f24; --soft: #5b6470; --line: #dde1e6;
  --accent: #2f6fb5; --bar: #cfe0f3; }
@media (prefers-color-scheme: dark) {
  :root { --page: #14171b; --card: #1d2126; --text: #e6e9ed; --soft: #9aa4b0; --line: #32383f; --accent: #7fb2e8;
    --bar: #2b415a; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--page); color: var(--text);
  font: 15px/1.5 system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif; }
main { max-width: 1500px; margin: 0 auto; padding: 28px 24px 60px; }
h1 { font-size: 26px; margin: 0 0 4px; }
h2 { font-size: 18px; margin: 0; }
p { margin: 4px 0; }
code { font: 13px/1.4 ui-monospace, "DejaVu Sans Mono", monospace; overflow-wrap: anywhere; }
.soft { color: var(--soft); }
section, .table { background: var(--card); border: 1px solid var(--line); border-radius: 10px; margin-top: 20px; }
section { padding: 16px 18px 18px; }
section header { display: flex; flex-wrap: wrap; gap: 2px 12px; align-items: baseline; }
section > p { margin: 2px 0 12px; }
.table { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
th, td { padding: 9px 16px; text-align: right; white-space: nowrap; border-top: 1px solid var(--line); }
thead th { border-top: 0; font-weight: 600; color: var(--soft); font-size: 13px; }
th:first-child, td:first-child { text-align: left; }
tbody th { font-weight: 600; }
td.reason { text-align: left; white-space: normal; color: var(--soft); }
td.bar { background: linear-gradient(90deg, var(--bar) calc(100% * var(--part)), transparent 0) no-repeat; }
.tag { font-size: 12px; font-weight: 500; color: var(--accent); border: 1px solid currentColor; border-radius: 99px;
  padding: 0 8px; margin-left: 8px; }
.pair { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 420px), 1fr)); gap: 16px; }
figure { margin: 0; max-width: 760px; }
figure img { display: block; width: 100%; height: auto; }
.frame { position: relative; border-radius: 6px; overflow: hidden; border: 1px solid var(--line); }
.flip { cursor: crosshair; }
.flip::after { content: ""; position: absolute; inset: 0; background-size: 100% 100%; opacity: 0; }
.flip:hover::after, .flip:focus::after { opacity: 1; }
figcaption { color: var(--soft); font-size: 13px; margin-top: 6px; display: flex; flex-wrap: wrap; gap: 4px 14px;
  justify-content: space-between; align-items: center; }
.scale { display: inline-flex; align-items: center; gap: 7px; font-variant-numeric: tabular-nums; }
.scale i { width: 150px; height: 10px; border-radius: 3px; display: inline-block; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 4px 16px; margin: 10px 0 0; }
dt { font-weight: 600; }
dd { margin: 0; color: var(--soft); }
@media (max-width: 640px) { dl { grid-template-columns: 1fr; } main { padding: 16px 12px 40px; } }
)css";

}  // namespace cdsm::cli

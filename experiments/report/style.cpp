// SPDX-License-Identifier: MIT
#include "experiments/report/style.h"

namespace bake::report {

const char* const k_style = R"(
:root { color-scheme: light dark; --page: #fbfaf8; --card: #ffffff; --ink: #23201c; --soft: #6b655c; --line: #e3ded6; --link: #8a4b0f;
  --good: #1d6b3a; --good-back: #e2f2e6; --bad: #9c1f1f; --bad-back: #fae3e1; --none: #5d5850; --none-back: #eeebe6; }
@media (prefers-color-scheme: dark) { :root { --page: #191714; --card: #221f1b; --ink: #ece7df; --soft: #a79f93; --line: #3a352e;
  --link: #e6a765; --good: #8fd6a4; --good-back: #1c3525; --bad: #f3a29b; --bad-back: #442120; --none: #bdb5a8; --none-back: #322e28; } }
* { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; }
body { margin: 0; background: var(--page); color: var(--ink); font: 1rem/1.55 system-ui, "Segoe UI", Roboto, "Liberation Sans", sans-serif; }
header, main, footer { max-width: 68rem; margin: 0 auto; padding: 0 1.25rem; }
header { padding-top: 2.5rem; }
h1 { font-size: 2rem; line-height: 1.2; margin: 0 0 .5rem; }
h2 { font-size: 1.35rem; line-height: 1.3; margin: 0 0 .75rem; display: flex; flex-wrap: wrap; gap: .35rem .75rem; align-items: center; }
h3 { font-size: 1rem; margin: 1.5rem 0 .4rem; }
p { margin: .5rem 0; max-width: 46rem; }
a { color: var(--link); }
section { background: var(--card); border: 1px solid var(--line); border-radius: .6rem; padding: 1.25rem; margin: 1.25rem 0; }
.soft, figcaption, caption { color: var(--soft); font-size: .9rem; }
.verdict { font-size: .8rem; font-weight: 600; line-height: 1.3; padding: .15rem .6rem; border-radius: 1rem; white-space: nowrap; }
.good { color: var(--good); background: var(--good-back); }
.bad { color: var(--bad); background: var(--bad-back); }
.none { color: var(--none); background: var(--none-back); }
.counts { display: flex; flex-wrap: wrap; gap: .5rem; padding: 0; margin: 1rem 0; list-style: none; }
.pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(26rem, 100%), 1fr)); gap: 1rem; margin: 1rem 0; }
figure { margin: 0; }
img { display: block; width: 100%; height: auto; border-radius: .35rem; }
img.chart { max-width: 44rem; }
figcaption { margin-top: .4rem; }
.wide { overflow-x: auto; margin: .75rem 0; }
table { border-collapse: collapse; width: 100%; font-size: .9rem; font-variant-numeric: tabular-nums; }
caption { text-align: left; padding-bottom: .35rem; }
th, td { text-align: left; vertical-align: top; padding: .4rem .75rem .4rem 0; border-bottom: 1px solid var(--line); }
td { min-width: 4.5rem; }
td:first-child { min-width: 9rem; }
td:first-child:has(> a) { min-width: 4.5rem; white-space: nowrap; }
th { color: var(--soft); font-weight: 600; white-space: nowrap; }
td ul { margin: 0; padding-left: 1.1rem; }
code { font: .92em ui-monospace, "DejaVu Sans Mono", "Liberation Mono", monospace; overflow-wrap: anywhere; }
summary { cursor: pointer; font-weight: 600; }
details { margin: .75rem 0; }
footer { padding-bottom: 3rem; }
@media (max-width: 40rem) { header { padding-top: 1.5rem; } h1 { font-size: 1.5rem; } section { padding: 1rem; }
  header, main, footer { padding-left: .75rem; padding-right: .75rem; }
  .cards thead { display: none; } .cards table, .cards tbody, .cards caption { display: block; }
  .cards tr { display: grid; grid-template-columns: repeat(auto-fill, minmax(5.5rem, 1fr)); gap: .4rem .75rem; padding: .7rem 0;
    border-bottom: 1px solid var(--line); }
  .cards td { min-width: 0; padding: 0; border: 0; overflow-wrap: anywhere; }
  .cards td:first-child, .cards td:last-child { grid-column: 1 / -1; }
  .cards td:not(:first-child)::before { content: attr(data-head); display: block; color: var(--soft); font-size: .8rem; } }
@media print { :root { color-scheme: light; --page: #fff; --card: #fff; --ink: #000; --soft: #444; --line: #bbb; --link: #000;
  --good-back: #fff; --bad-back: #fff; --none-back: #fff; --good: #000; --bad: #000; --none: #000; }
  body { font-size: 10pt; } section { border: 0; border-top: 1px solid var(--line); border-radius: 0; padding: .5rem 0; }
  figure, tr { break-inside: avoid; } h2 { break-after: avoid; } .wide { overflow: visible; } .verdict { border: 1px solid #000; } }
)";

}  // namespace bake::report

#pragma once
// How the page looks, on a screen from 320 px up and on A4: dark on white, each text 4.5:1 at least, nothing
// told by colour alone.

#include <string_view>

namespace windlass::debrief {

inline constexpr std::string_view kStyle = R"(
@page { size: A4; margin: 14mm 14mm 16mm; }
html { font: 16px/1.45 "Noto Sans", "Liberation Sans", Arial, sans-serif; color: #111; background: #fff; }
body { margin: 0; }
main { max-width: 50rem; margin: 0 auto; padding: 1rem; }
h1 { font-size: 1.5rem; line-height: 1.2; margin: 0 0 .8rem; }
h2 { font-size: 1.2rem; border-bottom: 2px solid #111; margin: 2rem 0 .7rem; }
h3 { font-size: 1rem; margin: 1.3rem 0 .4rem; }
h4 { font-size: .95rem; margin: 1rem 0 .3rem; }
a { color: #00418a; }
dl { display: grid; grid-template-columns: minmax(6rem, 11rem) 1fr; gap: .15rem 1rem; margin: 0; }
dt { font-weight: 600; }
dd { margin: 0; overflow-wrap: anywhere; }
.score { font-size: 1.5rem; font-weight: 700; margin: .3rem 0; }
.warning { border: 2px solid #111; padding: .4rem .6rem; }
.wide { overflow-x: auto; }
.wide a { white-space: nowrap; }
.wide + .wide { margin-top: 1rem; }
.wide:focus-visible, a:focus-visible, summary:focus-visible { outline: 3px solid #00418a; outline-offset: 2px; }
table { border-collapse: collapse; width: 100%; font-size: .9rem; }
caption { text-align: left; font-weight: 600; padding: .2rem 0; }
th, td { text-align: left; vertical-align: top; padding: .2rem .5rem .2rem 0; border-bottom: 1px solid #767676; font-weight: 400; }
thead th { font-weight: 600; border-bottom: 2px solid #111; }
.figure { text-align: right; font-variant-numeric: tabular-nums; }
figure { margin: 0 0 1rem; }
figcaption { font-size: .9rem; }
summary { cursor: pointer; }
code { font: .85rem/1.4 "Noto Sans Mono", "Liberation Mono", monospace; overflow-wrap: anywhere; }
svg { display: block; width: 100%; min-width: 34rem; height: auto; font: 11px "Noto Sans", "Liberation Sans", Arial, sans-serif; fill: #111; }
svg .grid { stroke: #d5d5d5; stroke-width: .8; fill: none; }
svg .zero { stroke: #555; stroke-width: 1; fill: none; }
svg .flags { stroke: #767676; stroke-width: .7; stroke-dasharray: 1 2; fill: none; }
svg .numbers { font-size: 10px; font-weight: 700; }
svg .off { stroke: #767676; stroke-width: 1; fill: none; }
svg .on { stroke: #111; stroke-width: 8; fill: none; }
svg .hull { fill: none; stroke: #111; stroke-width: 1.4; }
svg .swing { fill: none; stroke: #111; stroke-width: 1; stroke-dasharray: 6 4; }
svg .watch { fill: none; stroke: #111; stroke-width: 1.2; stroke-dasharray: 1.5 3; }
svg .anchor, svg .dragged { fill: none; stroke: #111; stroke-width: 1.6; }
svg .dot { fill: #111; }
svg .water { fill: #e4eef5; }
svg .surface { stroke: #2f5f86; stroke-width: 1; fill: none; }
svg .ground { fill: #e6dfd0; }
svg .bed { stroke: #4d4026; stroke-width: 1.4; fill: none; }
svg .plating { fill: #f4f4f4; fill-opacity: .85; stroke: #333; stroke-width: 1.1; }
svg .cable { fill: none; stroke-linejoin: round; stroke-linecap: round; }
svg .pull0 { stroke: #444; stroke-width: 1.3; }
svg .pull1 { stroke: #00418a; stroke-width: 2.2; }
svg .pull2 { stroke: #a34700; stroke-width: 3.2; }
svg .pull3 { stroke: #b00020; stroke-width: 4.4; }
svg .fluke { fill: none; stroke: #111; stroke-width: 2.6; stroke-linecap: round; }
.pair { display: flex; flex-wrap: wrap; gap: 0 1rem; }
.pair > figure { flex: 1 1 20rem; min-width: 0; }
.pair svg { width: 100%; height: auto; }
figure > p { margin: .8rem 0 .2rem; }
.key { break-after: avoid; }
@media (max-width: 30rem) {
  dl { grid-template-columns: 1fr; }
  dd { margin-bottom: .4rem; }
  thead { display: none; }
  tr { display: block; padding: .4rem 0; border-bottom: 1px solid #767676; }
  th, td, .figure { display: block; padding: 0; border: 0; text-align: left; }
  tbody th { font-weight: 600; }
  td:empty { display: none; }
  td:not([data-column=""])::before { content: attr(data-column) ": "; font-weight: 600; }
}
@media print {
  html { font-size: 10pt; }
  main { max-width: none; padding: 0; }
  h2, h3, h4, caption { break-after: avoid; }
  figure, tr, dl { break-inside: avoid; }
  .wide { overflow: visible; }
  svg { min-width: 0; }
  details { display: none; }
  a { color: #111; }
}
)";

/// Of a page with a ghost, and no other: behind the first.
inline constexpr std::string_view kGhostStyle = R"(
svg .ghost.on { stroke: #6f97bd; stroke-width: 4; stroke-dasharray: 6 4; }
section:has(#ghost-aligned:checked) .lines .ghost { transform: translateX(var(--ghost-moved)); }
section:has(#ghost-off:checked) .ghost { display: none; }
fieldset { border: 1px solid #767676; margin: .6rem 0; padding: .2rem .8rem .5rem; }
label { display: inline-block; margin-right: 1.2rem; }
.moved { display: none; }
@media print {
  fieldset { display: none; }
  section:has(#ghost-aligned:checked) fieldset + .moved { display: block; }
}
)";

} // namespace windlass::debrief

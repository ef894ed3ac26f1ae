// An address as a picture that a tablet's camera reads.

import { generate } from "lean-qr";

import { svg } from "../kit/dom";
import { t } from "../kit/language";

/** A square of SVG with a quiet zone around it, dark on light whatever the palette. */
export function qr(text: string): SVGSVGElement {
  const code = generate(text);
  const quiet = 4;
  let path = "";
  for (let y = 0; y < code.size; ++y)
    for (let x = 0; x < code.size; ++x) if (code.get(x, y)) path += `M${x + quiet} ${y + quiet}h1v1h-1z`;
  const side = code.size + 2 * quiet;
  return svg(
    "svg",
    { viewBox: `0 0 ${side} ${side}`, class: "qr", role: "img", "aria-label": t("QR code of the address") },
    svg("rect", { width: side, height: side, fill: "#fff" }),
    svg("path", { d: path, fill: "#000", "shape-rendering": "crispEdges" }),
  );
}

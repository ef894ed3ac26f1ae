// Colours of a quantity that everybody tells apart, also who does not tell red from green, and in a grey print: its
// lightness rises evenly, and its hue goes from blue to yellow through grey and nowhere else. The idea is that of
// Cividis (Nunez, Anderton, Renslow: Optimizing colormaps with consideration for color vision deficiency, PLoS ONE 13
// (7), e0199239, 2018); the colours are not theirs, but a straight line in OKLab that is worked out here.

type Triple = readonly [number, number, number];

/** OKLab: lightness, green to red, blue to yellow. Within what a screen can show; tuned for sea and steel behind it. */
const kLow: Triple = [0.36, -0.01, -0.12];
const kHigh: Triple = [0.92, -0.03, 0.15];
const kSteps = 64;

/** Linear RGB of OKLab (Ottosson: A perceptual color space for image processing, 2020; put in the public domain). */
export function linearOf([lightness, a, b]: Triple): Triple {
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ];
}

const ramp: readonly Triple[] = Array.from({ length: kSteps + 1 }, (_, i) => {
  const at = (k: 0 | 1 | 2): number => kLow[k] + (i / kSteps) * (kHigh[k] - kLow[k]);
  return linearOf([at(0), at(1), at(2)]);
});

/** Linear RGB, 0..1, of a share of the scale, 0..1; beyond it that of its end. */
export const rampAt = (share: number): Triple => ramp[Math.round(kSteps * Math.min(1, Math.max(0, share)))]!;

/** The same as CSS has it. */
export function rampCss(share: number): string {
  const coded = rampAt(share).map((x) => 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055));
  return `rgb(${coded.map(Math.round).join(" ")})`;
}

// Sounds made of arithmetic: noise and struck steel. The same each time, so that a test can count what it hears.

/** Noise that is the same each time: linear congruential generator, values -1..1. */
function* noise(seed: number): Generator<number> {
  let x = seed >>> 0;
  for (;;) {
    x = (Math.imul(x, 1664525) + 1013904223) >>> 0;
    yield x / 2 ** 31 - 1;
  }
}

function filled(
  context: BaseAudioContext,
  seconds: number,
  at: (t: number, noise: number) => number,
  seed = 1,
): AudioBuffer {
  const buffer = context.createBuffer(1, Math.ceil(seconds * context.sampleRate), context.sampleRate);
  const data = buffer.getChannelData(0);
  const values = noise(seed);
  for (let i = 0; i < data.length; ++i) data[i] = at(i / context.sampleRate, values.next().value as number);
  return buffer;
}

/** White noise of 3 s, to be looped. */
export const whiteNoise = (context: BaseAudioContext): AudioBuffer => filled(context, 3, (_, n) => 0.7 * n, 7);

/** Tones of a free bar, against its lowest. */
const kBarTones = [1, 2.76, 5.4, 8.93];

/**
 * Struck steel: tones of a bar whose lowest is that of so many Hz, dying away within so many s, and the noise of the
 * blow; sharp: 0..1, how hard the two that meet are.
 */
export function struck(
  context: BaseAudioContext,
  lowest: number,
  decay: number,
  sharp: number,
  seed: number,
): AudioBuffer {
  const seconds = 6 * decay;
  return filled(
    context,
    seconds,
    (t, n) => {
      let value = 0;
      kBarTones.forEach((ratio, k) => {
        value += Math.sin(2 * Math.PI * lowest * ratio * t) * Math.exp((-t * (1 + 0.8 * k)) / decay) * (0.6 - 0.12 * k);
      });
      const onset = Math.min(1, t / 0.0008);
      return onset * (0.6 * value + sharp * n * Math.exp(-t / 0.006));
    },
    seed,
  );
}

/** Something heavy into water: 1.6 s. */
export const splash = (context: BaseAudioContext): AudioBuffer =>
  filled(context, 1.6, (t, n) => n * Math.min(1, t / 0.02) * (Math.exp(-t / 0.12) + 0.5 * Math.exp(-t / 0.5)), 11);

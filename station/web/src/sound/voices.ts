// Nodes that sound all the time and are only turned up and down.

const kSmooth = 0.04; // s, time constant of every change, below what is heard as a step

/** A level that follows a value without clicks. */
export function glide(parameter: AudioParam, value: number, time: number, smooth = kSmooth): void {
  parameter.setTargetAtTime(value, time, smooth);
}

export function gainOf(context: BaseAudioContext, out: AudioNode, value = 0): GainNode {
  const gain = context.createGain();
  gain.gain.value = value;
  gain.connect(out);
  return gain;
}

export function filterOf(
  context: BaseAudioContext,
  out: AudioNode,
  type: BiquadFilterType,
  frequency: number,
  q = 1,
): BiquadFilterNode {
  const filter = context.createBiquadFilter();
  filter.type = type;
  filter.frequency.value = frequency;
  filter.Q.value = q;
  filter.connect(out);
  return filter;
}

/** A buffer that goes round for ever; offset: s into it, time: s of the context, from which it sounds. */
export function looped(
  context: BaseAudioContext,
  out: AudioNode,
  buffer: AudioBuffer,
  offset = 0,
  time = 0,
): AudioBufferSourceNode {
  const source = context.createBufferSource();
  source.buffer = buffer;
  source.loop = true;
  source.connect(out);
  source.start(time, offset);
  return source;
}

export function tone(
  context: BaseAudioContext,
  out: AudioNode,
  type: OscillatorType,
  frequency: number,
): OscillatorNode {
  const oscillator = context.createOscillator();
  oscillator.type = type;
  oscillator.frequency.value = frequency;
  oscillator.connect(out);
  oscillator.start(0);
  return oscillator;
}

/** Plays a buffer once. time: s of the context; rate: of its own pitch. */
export function once(
  context: BaseAudioContext,
  out: AudioNode,
  buffer: AudioBuffer,
  time: number,
  level: number,
  rate = 1,
): void {
  const source = context.createBufferSource();
  source.buffer = buffer;
  source.playbackRate.value = rate;
  const gain = gainOf(context, out, level);
  source.connect(gain);
  source.onended = () => gain.disconnect();
  source.start(time);
}

/** What keeps all sounds together from clipping, and leaves what is below -6 dB of full scale as it is. */
export function limiter(context: BaseAudioContext, out: AudioNode): AudioNode {
  const limit = context.createDynamicsCompressor();
  limit.threshold.value = -6;
  limit.knee.value = 0;
  limit.ratio.value = 20;
  limit.attack.value = 0.001;
  limit.connect(out);
  return limit;
}

/** A tone of so many s from time on, with soft ends. */
export function beep(
  context: BaseAudioContext,
  out: AudioNode,
  type: OscillatorType,
  frequency: number,
  time: number,
  seconds: number,
  level: number,
): void {
  const kEdge = 0.01;
  const gain = gainOf(context, out, 0);
  const oscillator = context.createOscillator();
  oscillator.type = type;
  oscillator.frequency.value = frequency;
  oscillator.connect(gain);
  gain.gain.setValueAtTime(0, time);
  gain.gain.linearRampToValueAtTime(level, time + kEdge);
  gain.gain.setValueAtTime(level, time + seconds - kEdge);
  gain.gain.linearRampToValueAtTime(0, time + seconds);
  oscillator.onended = () => gain.disconnect();
  oscillator.start(time);
  oscillator.stop(time + seconds);
}

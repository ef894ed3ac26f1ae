// What turns the windlass: an electric motor with its gear, or oil.

import { filterOf, gainOf, glide, looped, tone } from "./voices";

const kGearTeeth = 17; // that mesh in a turn of the motor's shaft
const kMotorTurns = 20; // a second at full speed: 1200 a minute
const kPumpTone = 222; // Hz: nine chambers at 1480 a minute, assumed

export interface DriveState {
  /** Of full speed, heaving positive. */
  speed: number;
  /** 0..1 of what its gauge shows at most. */
  load: number;
  power: boolean;
  tripped: boolean;
}

export class ElectricDriveSound {
  private readonly hum: GainNode;
  private readonly whine: GainNode;
  private readonly whines: { node: OscillatorNode; ratio: number }[];
  private readonly fan: GainNode;

  constructor(context: BaseAudioContext, out: AudioNode, noise: AudioBuffer) {
    this.hum = gainOf(context, out);
    const low = filterOf(context, this.hum, "lowpass", 500, 0.7);
    tone(context, low, "sawtooth", 60);
    tone(context, low, "sine", 120);
    this.whine = gainOf(context, out);
    const band = filterOf(context, this.whine, "lowpass", 2400, 0.7);
    this.whines = [
      { node: tone(context, band, "triangle", 1), ratio: kGearTeeth * kMotorTurns },
      { node: tone(context, band, "sawtooth", 1), ratio: 2.4 * kMotorTurns },
    ];
    this.fan = gainOf(context, out);
    looped(context, filterOf(context, this.fan, "bandpass", 900, 0.5), noise, 2);
  }

  play({ speed, load, power, tripped }: DriveState, time: number): void {
    const way = Math.abs(speed);
    const on = power && !tripped && (way > 0.02 || load > 0.02);
    glide(this.hum.gain, on ? 0.004 + 0.012 * load : 0, time, 0.1);
    for (const { node, ratio } of this.whines) glide(node.frequency, Math.max(1, ratio * way), time, 0.15);
    glide(this.whine.gain, way > 0.02 ? 0.003 + 0.006 * Math.min(1.5, way) : 0, time, 0.15);
    glide(this.fan.gain, 0.03 * Math.min(1.5, way), time, 0.3);
  }
}

export class HydraulicDriveSound {
  private readonly pump: GainNode;
  private readonly tones: { node: OscillatorNode; ratio: number }[];
  private readonly hiss: GainNode;

  constructor(context: BaseAudioContext, out: AudioNode, noise: AudioBuffer) {
    this.pump = gainOf(context, out);
    const low = filterOf(context, this.pump, "lowpass", 1200, 0.7);
    this.tones = [
      { node: tone(context, low, "sawtooth", kPumpTone), ratio: 1 },
      { node: tone(context, low, "triangle", 2 * kPumpTone), ratio: 2.003 },
    ];
    this.hiss = gainOf(context, out);
    looped(context, filterOf(context, this.hiss, "highpass", 2500, 0.7), noise, 2);
  }

  play({ speed, load, power }: DriveState, time: number): void {
    const way = Math.abs(speed);
    for (const { node, ratio } of this.tones) glide(node.frequency, kPumpTone * ratio * (1 - 0.06 * load), time, 0.2);
    glide(this.pump.gain, power ? 0.003 + 0.007 * load + 0.004 * Math.min(1, way) : 0, time, 0.2);
    glide(this.hiss.gain, power && load > 0.62 ? 0.1 * load : 0.015 * way, time, 0.2); // the relief valve blows
  }
}

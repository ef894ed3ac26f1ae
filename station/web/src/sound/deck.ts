// All that is heard on the forecastle, mixed.

import { ClutchState } from "../wire/generated";
import { TalkbackSound } from "./alarm";
import { BrakeSound } from "./brake";
import { ChainSound } from "./chain";
import { type DriveState, ElectricDriveSound, HydraulicDriveSound } from "./drive";
import { type Ears, type Places, listen, placed } from "./place";
import { splash, struck, whiteNoise } from "./samples";
import { Strikes } from "./strikes";
import { SurroundingsSound } from "./surroundings";
import { gainOf, once } from "./voices";

/** What makes a noise on one side. */
export interface WindlassHeard {
  /** m/s, paying out positive. */
  cableSpeed: number;
  /** 0..1 of the cable's breaking load, where a cell shows it; else 0. */
  load: number;
  jumping: boolean;
  /** 0 none .. 3 screams. */
  brakeNoise: number;
  /** LiningSeen, 0..4. */
  heat: number;
  drive: DriveState;
  clutch: ClutchState;
}

const kClatter = 9; // blows a second of claws that pass each other

class WindlassSound {
  private readonly gypsy: AudioNode;
  private readonly water: AudioNode;
  private readonly chain: ChainSound;
  private readonly brake: BrakeSound;
  private readonly drive: ElectricDriveSound | HydraulicDriveSound;
  private readonly claws: Strikes;
  private clutch: ClutchState | undefined;

  constructor(
    private readonly context: BaseAudioContext,
    out: AudioNode,
    noise: AudioBuffer,
    { gypsy, pipe, water }: Places,
    diameter: number,
    hydraulic: boolean,
  ) {
    this.gypsy = placed(context, out, gypsy);
    this.water = placed(context, out, water);
    this.chain = new ChainSound(context, { gypsy: this.gypsy, pipe: placed(context, out, pipe) }, noise, diameter);
    this.brake = new BrakeSound(context, this.gypsy, noise);
    this.drive = new (hydraulic ? HydraulicDriveSound : ElectricDriveSound)(context, this.gypsy, noise);
    const claw = struck(context, 620, 0.012, 1, 21).getChannelData(0);
    this.claws = new Strikes(context, this.gypsy, { blows: [claw], spread: 0 });
  }

  play(heard: WindlassHeard, time: number): void {
    this.chain.play(heard.cableSpeed, heard.load, heard.jumping, time);
    this.brake.play(heard.brakeNoise, heard.cableSpeed, heard.heat, time);
    this.drive.play(heard.drive, time);
    if (this.clutch !== undefined && this.clutch !== heard.clutch && heard.clutch !== ClutchState.CLUTCH_ENGAGING)
      this.chain.blow(time, 0.2);
    this.clutch = heard.clutch;
    const passing = Math.abs(heard.drive.speed) > 0.02 || Math.abs(heard.cableSpeed) > 0.02;
    const clatters = heard.clutch === ClutchState.CLUTCH_ENGAGING && passing;
    this.claws.play(clatters ? kClatter : 0, 0.2, time);
  }

  shackle(time: number): void {
    this.chain.shackle(time);
  }
  blow(time: number): void {
    this.chain.blow(time, 0.3);
  }
  splash(buffer: AudioBuffer, time: number): void {
    once(this.context, this.water, buffer, time, 1);
  }
}

export class DeckSound {
  private readonly noise: AudioBuffer;
  private readonly water: AudioBuffer;
  private readonly deck: GainNode;
  private readonly windlasses: (WindlassSound | undefined)[] = [];
  private readonly surroundings: SurroundingsSound;
  readonly talkback: TalkbackSound;

  /**
   * out: what all goes to. The context may be a real one or an OfflineAudioContext; its loadStrikes() has been waited
   * for.
   */
  constructor(
    private readonly context: BaseAudioContext,
    out: AudioNode,
  ) {
    this.noise = whiteNoise(context);
    this.water = splash(context);
    this.deck = gainOf(context, out, 1);
    this.surroundings = new SurroundingsSound(context, this.deck, this.noise);
    this.talkback = new TalkbackSound(context, out);
  }

  /** A windlass and its cable; diameter: m of the links' wire. */
  fit(side: number, places: Places, diameter: number, hydraulic: boolean): void {
    this.windlasses[side] ??= new WindlassSound(this.context, this.deck, this.noise, places, diameter, hydraulic);
  }

  /** Whose ears hear it. */
  listen(ears: Ears, time: number): void {
    listen(this.context, ears, time);
  }

  /** What is heard of a side from time on; s of the context. */
  windlass(side: number, heard: WindlassHeard, time: number): void {
    this.windlasses[side]?.play(heard, time);
  }
  /** force: Beaufort. */
  wind(force: number, time: number): void {
    this.surroundings.play(force, time);
  }
  splash(side: number, time: number): void {
    this.windlasses[side]?.splash(this.water, time);
  }
  shackle(side: number, time: number): void {
    this.windlasses[side]?.shackle(time);
  }
  /** The stopper's bar, the clutch's fork. */
  blow(side: number, time: number): void {
    this.windlasses[side]?.blow(time);
  }
  /** Faded while nothing is heard of the exercise: 0..1. */
  level(share: number, time: number): void {
    this.deck.gain.setTargetAtTime(share, time, 0.2);
  }
}

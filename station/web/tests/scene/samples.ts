// Recorded samples in the place of a connection.

import type { Samples } from "../../src/scene/from_truth";
import type { ChannelName, Channels, Heard } from "../../src/wire/connection";

export interface Recorded {
  scenes: Record<string, unknown>[];
  instants: ({ name: string; scene: number } & Record<string, unknown>)[];
}

/** The samples of one instant; changed: fields that differ from what was recorded, by topic and key. */
export class OneInstant implements Samples {
  private readonly samples = new Map<string, unknown>();

  constructor(recorded: Recorded, name: string, changed: Record<string, object> = {}) {
    const instant = recorded.instants.find((i) => i.name === name);
    if (!instant) throw new Error(`no instant ${name}: ${recorded.instants.map((i) => i.name).join(", ")}`);
    const { name: _, scene, ...streams } = instant;
    for (const [topic, sample] of Object.entries({ ...recorded.scenes[scene], ...streams })) {
      const key = topic.includes("/") ? topic : `${topic}/`;
      this.samples.set(key, typed({ ...(sample as object), ...changed[key.replace(/\/$/, "")] }));
    }
  }

  latest<C extends ChannelName>(topic: C, key: string | number = ""): Channels[C] | undefined {
    return this.samples.get(`${topic}/${key}`) as Channels[C] | undefined;
  }
  track<C extends ChannelName>(topic: C, key: string | number = ""): readonly Heard<Channels[C]>[] {
    const sample = this.latest(topic, key);
    return sample ? [{ sample, at: 0 }] : [];
  }
}

/** Lists of numbers as the decoders make them. */
function typed(sample: Record<string, unknown> | object): object {
  const made = { ...sample } as Record<string, unknown>;
  for (const field of ["nodes", "tension", "hull_corners", "heights"])
    if (Array.isArray(made[field])) made[field] = Float32Array.from(made[field] as number[]);
  if (Array.isArray(made.hull_triangles)) made.hull_triangles = Uint32Array.from(made.hull_triangles as number[]);
  if (Array.isArray(made.soils)) made.soils = Uint8Array.from(made.soils as number[]);
  return made;
}

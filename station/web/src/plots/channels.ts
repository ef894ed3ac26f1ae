// What an instructor's plots show: figures of the truth and of the gauges, in the trade's units, and their limits.

import { limits } from "../../../../words/words.json";
import { loadsMeasured } from "../kit/measured";
import { type Measure, cableSpeeds, celsius, degrees, kTonne, knots, loads } from "../kit/units";
import type { Connection } from "../wire/connection";
import type { PredictedCable } from "../wire/generated";
import { t, writtenFigure } from "../kit/language";

/** What was heard last of each topic: of a link, or at a moment of the past. */
export type Latest = Pick<Connection, "latest">;

/** One figure over time. */
export interface Channel {
  id: string;
  label: string;
  decimals: number;
  /** In the unit of its pane, in SI where that is a measure; NaN where nothing is known. */
  read: (link: Latest, side: number) => number;
  /** What a gauge shows, or a set point: dashed. */
  dashed?: boolean;
  /** What a prediction says of it, as read() gives it. */
  ahead?: (cable: PredictedCable) => number;
  /** It may leave the picture: what could be held is often far above what is. */
  leaves?: boolean;
}

/** A line that a figure should not cross; value: as channels read. */
export interface Limit {
  label: string;
  value: number;
}

const ofBreaking = (share: number, breakingLoad: number): Limit => ({
  label: t("{share} breaking load", { share: writtenFigure(`${share}`) }),
  value: share * breakingLoad,
});

/** Some figures of one unit, drawn together. */
export interface PaneSpec {
  id: string;
  title: string;
  /** On its chip. */
  short: string;
  unit: string | Measure;
  /** Its scale goes up to this at least, as channels read, so that a figure at rest does not look alive. */
  least: number;
  channels: Channel[];
  /** Of the ship, the same for both sides. */
  shared?: boolean;
  limits?: (link: Connection, side: number) => Limit[];
}

const windlass = (link: Latest, side: number) => link.latest("WindlassLoad", side);
const anchor = (link: Latest, side: number) => link.latest("AnchorState", side);
const bar = (pressure: number): number => pressure / 1e5;

/** A channel of WindlassLoad. */
function ofWindlass(
  id: string,
  label: string,
  decimals: number,
  read: (load: NonNullable<ReturnType<typeof windlass>>) => number,
  more: Partial<Channel> = {},
): Channel {
  return {
    id,
    label,
    decimals,
    ...more,
    read: (link, side) => {
      const load = windlass(link, side);
      return load ? read(load) : NaN;
    },
  };
}

/** Of a load: NaN until there are loads. */
const ofLoad: typeof ofWindlass = (id, label, decimals, read, more) =>
  ofWindlass(id, label, decimals, (load) => (loadsMeasured(load) ? read(load) : NaN), more);

function ofAnchor(
  id: string,
  label: string,
  decimals: number,
  read: (state: NonNullable<ReturnType<typeof anchor>>) => number,
): Channel {
  return {
    id,
    label,
    decimals,
    read: (link, side) => {
      const state = anchor(link, side);
      return state ? read(state) : NaN;
    },
  };
}

export const panes: readonly PaneSpec[] = [
  {
    id: "loads",
    title: t("Loads"),
    short: t("Loads"),
    unit: loads,
    least: 10 * kTonne,
    channels: [
      ofLoad("hawse", t("hawse"), 1, (l) => l.hawse_tension, { ahead: (c) => c.hawse_tension }),
      ofLoad("gypsy", t("gypsy"), 1, (l) => l.gypsy_load, { ahead: (c) => c.gypsy_load }),
      ofLoad("brake", t("brake"), 1, (l) => l.brake_load, { ahead: (c) => c.brake_load }),
      ofLoad("capacity", t("brake holds"), 1, (l) => l.brake_capacity, { dashed: true, leaves: true }),
    ],
    limits: (link, side) => {
      const load = windlass(link, side);
      if (!load) return [];
      return [
        { label: t("brake rating"), value: load.brake_rating },
        ofBreaking(limits.load_allowed.value, load.breaking_load),
        ofBreaking(limits.load_stopper.value, load.breaking_load),
      ];
    },
  },
  {
    id: "speed",
    title: t("Cable speed"),
    short: t("Speed"),
    unit: cableSpeeds,
    least: 1,
    channels: [ofWindlass("speed", t("paying out +"), 2, (l) => l.cable_speed, { ahead: (c) => c.cable_speed })],
    limits: () => [
      { label: t("fast"), value: limits.cable_fast.value },
      { label: t("runaway"), value: limits.cable_runaway.value },
    ],
  },
  {
    id: "out",
    title: t("Cable out"),
    short: t("Out"),
    unit: "m",
    least: 10,
    channels: [
      ofWindlass("out", t("out|cable"), 1, (l) => l.cable_out, { ahead: (c) => c.cable_out }),
      ofWindlass("counter", t("counter"), 1, (l) => l.cable_out_indicated, { dashed: true }),
    ],
  },
  {
    id: "temperature",
    title: t("Brake heat"),
    short: t("Brake \u00b0C"),
    unit: "\u00b0C",
    least: 50,
    channels: [
      ofWindlass("lining", t("lining"), 0, (l) => celsius(l.lining_temperature), {
        ahead: (c) => celsius(c.lining_temperature),
      }),
      ofWindlass("drum", t("drum"), 0, (l) => celsius(l.drum_temperature)),
    ],
    limits: () => [
      { label: t("smokes"), value: 250 },
      { label: t("burns"), value: 400 },
    ],
  },
  {
    id: "motor",
    title: t("Motor"),
    short: t("Motor"),
    unit: t("A or bar"),
    least: 100,
    channels: [
      ofWindlass("motor", t("current"), 0, (l) => (l.motor_pressure > 0 ? bar(l.motor_pressure) : l.motor_current)),
    ],
  },
  {
    id: "levers",
    title: t("Levers"),
    short: t("Levers"),
    unit: "%",
    least: 100,
    channels: [
      ofWindlass("wheel", t("brake on"), 0, (l) => 100 * l.brake_position),
      ofWindlass("lever", t("speed, heave +"), 0, (l) => 100 * l.speed_lever),
    ],
  },
  {
    id: "holding",
    title: t("Anchor holding"),
    short: t("Holding"),
    unit: loads,
    least: 10 * kTonne,
    channels: [
      ofAnchor("used", t("used"), 1, (a) => a.holding_used),
      { ...ofAnchor("holds", t("at most"), 1, (a) => a.holding_capacity), dashed: true, leaves: true },
    ],
  },
  {
    id: "dragged",
    title: t("Anchor dragged"),
    short: t("Dragged"),
    unit: "m",
    least: 5,
    channels: [ofAnchor("dragged", t("dragged"), 1, (a) => a.dragged)],
  },
  {
    id: "ship",
    title: t("Ship and wind"),
    short: t("Ship, wind"),
    unit: "kn",
    least: 5,
    shared: true,
    channels: [
      {
        id: "sog",
        label: "SOG",
        decimals: 1,
        read: (link) => knots(link.latest("ShipState")?.speed_over_ground ?? NaN),
      },
      {
        id: "wind",
        label: t("wind"),
        decimals: 1,
        read: (link) => knots(link.latest("EnvironmentState")?.now.wind_speed ?? NaN),
      },
    ],
  },
  {
    id: "heading",
    title: t("Heading"),
    short: t("Heading"),
    unit: "\u00b0",
    least: 360,
    shared: true,
    channels: [
      {
        id: "heading",
        label: t("heading"),
        decimals: 0,
        read: (link) => degrees(link.latest("ShipState")?.heading ?? NaN),
      },
      {
        id: "wind_from",
        label: t("wind from"),
        decimals: 0,
        read: (link) => degrees(link.latest("EnvironmentState")?.now.wind_from ?? NaN),
      },
    ],
  },
];

/** Where each channel of a side lies in the history; those that are the ship's lie once. */
export interface Place {
  channel: Channel;
  side: number;
}

export const places: readonly Place[] = panes.flatMap((pane) =>
  (pane.shared ? [0] : [0, 1]).flatMap((side) => pane.channels.map((channel) => ({ channel, side }))),
);

/** The place of a pane's channel; side as the desk looks at it. */
export function placeOf(pane: PaneSpec, channel: Channel, side: number): number {
  return places.findIndex((p) => p.channel === channel && p.side === (pane.shared ? 0 : side));
}

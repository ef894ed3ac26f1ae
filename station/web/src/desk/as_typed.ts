// What the server refuses, it refuses in SI; an instructor who typed knots is told in knots.

import { clock, figure } from "../kit/units";
import { t } from "../kit/language";

/** How a figure was typed. */
export interface Typed {
  label: string;
  unit: string;
  /** From SI as it is typed; round: to the figure's last decimal. */
  write: (si: number, round: (value: number) => number) => string;
}
/** How the fields of an order were typed, by their name on the wire; undefined: as the wire has it. */
export type TypedFields = (field: string) => Typed | undefined;

/** A figure in a unit of so many SI. */
export const inUnit = (label: string, unit: string, si: number): Typed => ({
  label,
  unit,
  write: (value, round) => {
    const tenths = round((10 * value) / si);
    return figure(tenths / 10, tenths % 10 ? 1 : 0);
  },
});
/** An exercise time, m:ss. */
export const inMinutes = (label: string): Typed => ({ label, unit: "", write: (value) => clock(value) });

const kRefusal = /^(?:\(.*?\) )?(\w+) from .*?: (?:\w+\.)*(\w+) = (\S+) refused; allowed: (.*)$/;
const kRange = /^(-?[\d.e+-]+)\.\.(-?[\d.e+-]+)/;

/**
 * The server's sentence about an order's figure, in the words and the unit in which it was typed; others as they are.
 */
export function asTyped(text: string, fields: TypedFields): string {
  const [, topic, field, value, allowed] = kRefusal.exec(text) ?? [];
  const typed = field && fields(field);
  if (!typed) return text;
  const range = kRange.exec(allowed!);
  const last = typed.unit && ` ${typed.unit}`;
  const may = range
    ? `${t("{least} to {most}", {
        least: typed.write(Number(range[1]), Math.ceil),
        most: typed.write(Number(range[2]), Math.floor),
      })}${last}`
    : allowed!;
  const given = `${typed.label} ${typed.write(Number(value), Math.round)}${last}`;
  return t("{topic}: {given} refused; allowed: {may}", { topic: topic!.replace("Command", ""), given, may });
}

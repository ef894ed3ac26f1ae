// A name for a new class: of an earlier one the results are kept under its own, and one that goes on from it has both.

const kLongest = 24; // letters, as the door takes them

const kGoesOn = /-(again|next)(-[a-z]+)?$/;

/** What a class is called that goes on from one of that name: "gale-again", and that one's "gale-again" once more. */
export const nameAfter = (name: string, what: "again" | "next"): string =>
  `${name.replace(kGoesOn, "").slice(0, kLongest - 1 - what.length)}-${what}`;

/** The letter behind that one: "-b" of "-a", "-za" of "-z". */
const next = (behind: string): string => {
  const last = behind.charCodeAt(behind.length - 1);
  return behind.endsWith("z") ? `${behind}a` : behind.slice(0, -1) + String.fromCharCode(last + 1);
};

/**
 * That name, or the same with a letter behind it, which none of those that are taken has: "sun", "sun-b", "sun-c". With
 * a number it would be called as an exercise of the first.
 */
export function freeName(wanted: string, taken: readonly string[]): string {
  let name = wanted;
  for (let behind = next("-a"); taken.includes(name); behind = next(behind))
    name = wanted.slice(0, kLongest - behind.length) + behind;
  return name;
}

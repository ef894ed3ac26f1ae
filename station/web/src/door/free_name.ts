// A name for a new class: of an earlier one the results are kept under its own.

const kLongest = 24; // letters, as the door takes them

/** That name, or the same with a number behind it, which none of those that are taken has: "sun", "sun-2", "sun-3". */
export function freeName(wanted: string, taken: readonly string[]): string {
  let name = wanted;
  for (let i = 2; taken.includes(name); ++i) {
    const number = `-${i}`;
    name = wanted.slice(0, kLongest - number.length) + number;
  }
  return name;
}

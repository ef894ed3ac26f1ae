// In which language the pages are read. A sentence in the sources is English and is its own key; words/pages_de.json
// has the German beside it. Orders and reports are SMCP English in every language: they do not come by here.

type Catalogue = Record<string, string>;

/** By their codes, as they call themselves. */
export const languages = { en: "English", de: "Deutsch" } as const;
export type Language = keyof typeof languages;

const kChosen = "windlass.language";
const isLanguage = (code: string | null): code is Language => code !== null && Object.hasOwn(languages, code);

/** What the person has chosen in this browser, else the first of the browser's languages that there is. */
function wanted(): Language {
  try {
    const chosen = localStorage.getItem(kChosen);
    if (isLanguage(chosen)) return chosen;
  } catch {
    // a browser that keeps nothing goes by its own languages
  }
  const browsers = typeof navigator === "undefined" ? [] : (navigator.languages ?? []);
  return browsers.map((tag) => tag.slice(0, 2).toLowerCase()).find(isLanguage) ?? "en";
}

/** Of this page as long as it is open: another one loads it anew. */
export let language: Language = typeof document === "undefined" ? "en" : wanted();

/** A file of its own, which nobody loads who reads English. */
let catalogue: Catalogue = {};
if (language === "de")
  try {
    catalogue = (await import("../../../../words/pages_de.json")).default;
  } catch {
    language = "en"; // better understood by half than not opened
  }
if (typeof document !== "undefined") document.documentElement.lang = language;

/** Keeps the person's choice and loads the page anew. */
export function chooseLanguage(next: Language): void {
  try {
    localStorage.setItem(kChosen, next);
  } catch {
    return; // it would come back as it was
  }
  location.reload();
}

type Places<S extends string> = S extends `${string}{${infer Place}}${infer Rest}` ? Place | Places<Rest> : never;
type Given<Name extends string> = Record<Name, string | number>;
/** Of a sentence that is joined of several, nobody knows its places. */
type Values<S extends string> = string extends S
  ? [values?: Given<string>]
  : [Places<S>] extends [never]
    ? []
    : [values: Given<Places<S>>];

/** Words that English does not tell apart have a note behind a bar, which nobody reads: "off|of a switch". */
const withoutNote = (english: string): string => english.replace(/\|.*$/s, "");

/** A sentence of the sources in the person's language, its places filled in. */
export function t<S extends string>(english: S, ...[values]: Values<S>): string {
  const sentence = catalogue[english] ?? withoutNote(english);
  const given = values as Record<string, string | number> | undefined;
  return given ? sentence.replace(/\{(\w+)\}/g, (place, name: string) => `${given[name] ?? place}`) : sentence;
}

/** The browser's tab; in English the page has its title from its own file. */
export function titlePage(title: string): void {
  if (language !== "en") document.title = `Windlass: ${title}`;
}

/** Words that come from elsewhere, of words.json or the server: as they came where the catalogue has none. */
export const translated = (english: string): string => catalogue[english] ?? english;

/** A figure as it is written there, of one with a point: "4.6", "4,6". */
export const writtenFigure = (figure: string): string => (language === "de" ? figure.replace(".", ",") : figure);

/** A figure as it was typed, with a point or a comma: one that Number() reads. */
export const typedFigure = (text: string): string => text.trim().replace(/^([^.,]*),([^.,]*)$/, "$1.$2");

const kPlace = /\{[^}]*\}/g;

/** Words of ours, or a list of them, each with its number: "2 unsolved, 1 too long". */
function filledIn(given: string): string {
  const whole = translated(given);
  if (whole !== given) return whole;
  return given
    .split(", ")
    .map((part) => {
      const [, count = "", words = ""] = /^(\d+ )?(.*)$/s.exec(part) ?? [];
      return count + translated(words);
    })
    .join(", ");
}

/**
 * What the server made of a sentence with places {0}, {.1} ..., in the person's language; what it filled in, as far as
 * the catalogue has it, but for places with a name. As it came where it is another sentence.
 */
export function translatedAs(template: string, text: string): string {
  const sentence = catalogue[template];
  if (sentence === undefined) return translated(text);
  const literal = template.split(kPlace).map((part) => part.replace(/[.*+?^${}()|[\]\\]/g, "\\$&"));
  const found = new RegExp(`^${literal.join("(.*?)")}$`, "s").exec(text);
  const places = [...template.matchAll(kPlace)].map(([place]) => place);
  const filled = (place: string): string => {
    const given = found?.[places.indexOf(place) + 1] ?? "";
    if (/^[\d.]+$/.test(given)) return writtenFigure(given);
    return /[a-z]/.test(place) ? given : filledIn(given);
  };
  return found ? sentence.replace(kPlace, filled) : text;
}

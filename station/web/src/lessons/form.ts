// What the parts of a form share: the document, what it takes over, names to offer, and mistakes at their fields.

import { h, setAttribute } from "../kit/dom";
import { type Json, type JsonObject, at, isObject, scalarText } from "./json";
import { label, quantities } from "./schema";

export interface Mistake {
  /** JSON pointer; "": of the whole. */
  at: string;
  text: string;
}

/** Names that the station program knows. */
export interface Names {
  events: string[];
  faults: string[];
}

/** Which names a field may have, by its own name: those of the document's entries, or the program's. */
const offered: { [field: string]: (lesson: JsonObject, names: Names) => string[] } = {
  moment: (lesson) => Object.keys((lesson.moments as JsonObject | undefined) ?? {}),
  at: (lesson) => offered.moment!(lesson, { events: [], faults: [] }),
  objective: (lesson) => idsOf(lesson.objectives),
  given: (lesson) => idsOf(lesson.orders),
  repeated: (lesson) => idsOf(lesson.orders),
  done: (lesson) => idsOf(lesson.orders),
  orders: (lesson) => idsOf(lesson.orders),
  fails: (lesson) => idsOf(lesson.criteria),
  of: () => [...quantities.keys()],
  event: (_, names) => names.events,
  abort: (_, names) => names.events,
  code: (_, names) => names.faults,
};

const idsOf = (list: Json | undefined): string[] =>
  Array.isArray(list) ? list.map((each) => (isObject(each) ? scalarText(each.id) : "")).filter(Boolean) : [];

export class Form {
  /** Values of the fields that the document leaves out; null: not known. */
  inherited: Json = null;
  private mistakes: readonly Mistake[] = [];

  constructor(
    readonly document: JsonObject,
    private readonly names: Names,
    private readonly whenChanged: () => void,
  ) {}

  changed(): void {
    this.whenChanged();
  }

  /** What holds where a field is left out; undefined: nothing. Lists are taken over as wholes. */
  takenOver(pointer: string): Json | undefined {
    return /\/\d+(\/|$)/.test(pointer) ? undefined : at(this.inherited, pointer);
  }

  /** Names that fit a field; none: anything may be typed. */
  offers(pointer: string): string[] {
    const field = pointer.replace(/\/\d+$/, "").replace(/.*\//, "");
    const lesson = this.document.lesson;
    return offered[field]?.(isObject(lesson) ? lesson : {}, this.names) ?? [];
  }

  /** Shows each at its field, or at the innermost part around it. Called again after a part was drawn anew. */
  tell(root: HTMLElement, mistakes: readonly Mistake[] = this.mistakes): void {
    this.mistakes = mistakes;
    for (const place of root.querySelectorAll("[data-at]")) {
      place.classList.remove("wrong");
      place.querySelector(":scope > .mistake")?.remove();
      for (const input of place.querySelectorAll(":scope > .control > :is(input, select, textarea)"))
        setAttribute(input, "aria-invalid", undefined);
    }
    for (const mistake of mistakes) {
      const place = placeOf(root, mistake.at);
      if (!place) continue;
      const shown = (place as HTMLElement).dataset.at!;
      const field = mistake.at.slice(shown.length + 1);
      const words = `${field ? `${label(field.replaceAll("/", ", "))}: ` : ""}${mistake.text}`;
      place.classList.add("wrong");
      const told = place.querySelector(":scope > .mistake");
      if (told) told.textContent += `; ${words}`;
      else place.append(h("p", { class: "mistake", role: "alert" }, words));
      for (const input of place.querySelectorAll(":scope > .control > :is(input, select, textarea)"))
        setAttribute(input, "aria-invalid", "true");
    }
  }
}

/** The innermost part of a form in which a pointer lies. */
export function placeOf(root: HTMLElement, pointer: string): Element | undefined {
  for (let inner = pointer; ; inner = inner.replace(/\/[^/]*$/, "")) {
    const found = root.querySelector(`[data-at="${CSS.escape(inner)}"]`);
    if (found) return found;
    if (!inner) return undefined;
  }
}

// Fields of one line: a figure, a word, one of several, several of several, bounds of a figure.

import { h, setText } from "../kit/dom";
import type { Form } from "./form";
import { type Json, type JsonObject, type Place, isObject, isScalar, scalarText } from "./json";
import { type Schema, label, resolved, typesOf } from "./schema";
import { inTrade } from "./trade";
import { t, typedFigure } from "../kit/language";

let lists = 0;

/** What a figure that was typed becomes; what is none stays as it is, for the station to say what is allowed. */
const figureOf = (text: string): Json => {
  const figure = Number(typedFigure(text));
  return text.trim() !== "" && Number.isFinite(figure) ? figure : text;
};

const shown = (value: Json | undefined): string =>
  value === undefined ? "" : isScalar(value) ? `${value}` : JSON.stringify(value);

/** An input for text or a figure; name: for screen readers. */
function typed(schema: Schema, place: Place, form: Form, name: string): HTMLElement[] {
  const types = typesOf(schema);
  const number = !types.includes("string");
  const description = schema.description ?? "";
  const taken = form.takenOver(place.pointer) ?? schema.default;
  const props = {
    "aria-label": name,
    value: shown(place.get()),
    placeholder: shown(taken),
    oninput: () => {
      const text = input.value;
      place.set(text === "" ? undefined : number ? figureOf(text) : text);
      trade();
      form.changed();
    },
  };
  const words = h("span", { class: "trade quiet" });
  const trade = (): void => {
    const value = place.get() ?? taken;
    setText(words, number && typeof value === "number" ? inTrade(description, value) : "");
  };
  const long = !number && (schema.maxLength ?? 256) > 256;
  const input: HTMLInputElement | HTMLTextAreaElement = long
    ? h("textarea", { ...props, rows: 6 })
    : h("input", { ...props, type: "text" });
  if (number) input.inputMode = "decimal";
  if (number) input.classList.add("figure");
  const offers = number ? [] : form.offers(place.pointer);
  if (offers.length === 0) return (trade(), [input, words]);
  const id = `offers-${++lists}`;
  input.setAttribute("list", id);
  return [input, h("datalist", { id }, ...offers.map((value) => h("option", { value })))];
}

/** One of several; "" leaves it out. values: their words by JSON value. */
function choice(
  values: readonly [value: Json, words: string][],
  place: Place,
  form: Form,
  name: string,
  otherwise: string,
): HTMLElement {
  const select = h("select", {
    "aria-label": name,
    onchange: () => {
      place.set(select.value === "" ? undefined : values[Number(select.value)]![0]);
      form.changed();
    },
  });
  const now = place.get();
  select.append(h("option", { value: "" }, otherwise));
  values.forEach(([, words], i) => select.append(h("option", { value: `${i}` }, words)));
  const known = values.findIndex(([value]) => value === now);
  if (now !== undefined && known < 0)
    select.append(h("option", { value: `${values.length}`, disabled: true }, shown(now)));
  select.value = now === undefined ? "" : `${known < 0 ? values.length : known}`;
  return select;
}

/** Several names: one alone stays a text, as it was written, where the schema takes both. */
function names(schema: Schema, place: Place, form: Form, name: string): HTMLElement[] {
  const one = typesOf(schema).includes("string");
  const items = resolved(schema.items ?? {});
  const now = (): Json[] => {
    const value = place.get();
    return value === undefined || value === "" ? [] : Array.isArray(value) ? value : [value];
  };
  const put = (list: Json[]): void => {
    place.set(list.length === 0 && one ? undefined : one && list.length === 1 ? list[0] : list);
    form.changed();
  };
  if (items.enum && items.enum.length <= 12) {
    const taken = form.takenOver(place.pointer) ?? schema.default;
    const start = place.get() === undefined && Array.isArray(taken) ? taken : now();
    const boxes = items.enum.map((value) => {
      const box = h("input", {
        type: "checkbox",
        checked: start.includes(value),
        onchange: () => put(items.enum!.filter((_, i) => (boxes[i] as HTMLInputElement).checked)),
      });
      return box;
    });
    return [
      h(
        "span",
        { class: "boxes", role: "group", "aria-label": name },
        ...items.enum.map((value, i) => h("label", {}, boxes[i], label(scalarText(value)))),
      ),
    ];
  }
  if (!one && (items.maxLength ?? 0) > 100) {
    // sentences, which have commas of their own
    const lines = h("textarea", {
      rows: 4,
      "aria-label": `${name}, ${t("one a line")}`,
      value: now().map(shown).join("\n"),
      oninput: () =>
        put(
          lines.value
            .split("\n")
            .map((line) => line.trim())
            .filter(Boolean),
        ),
    });
    return [lines];
  }
  const figures = !typesOf(items).includes("string") && !items.enum;
  const offers = items.enum ? items.enum.map(String) : form.offers(place.pointer);
  const input = h("input", {
    type: "text",
    class: "names",
    "aria-label": `${name}, ${t("with commas between")}`,
    placeholder: form.takenOver(place.pointer) !== undefined ? shown(form.takenOver(place.pointer)) : "a, b",
    value: now().map(shown).join(", "),
    oninput: () => {
      const list = input.value
        .split(",")
        .map((part) => part.trim())
        .filter(Boolean);
      put(figures ? list.map(figureOf) : list);
    },
  });
  if (offers.length === 0) return [input];
  const add = h("select", {
    "aria-label": `${name}: ${t("add one")}`,
    onchange: () => {
      put([...now(), add.value]);
      input.value = now().map(shown).join(", ");
      add.value = "";
    },
  });
  add.append(h("option", { value: "" }, t("add \u2026")), ...offers.map((value) => h("option", { value }, value)));
  return [input, add];
}

const kAtLeast = t("at least");

/** A figure alone ("at least"), or what it lies above and below. */
function bounds(schema: Schema, place: Place, form: Form, name: string): HTMLElement[] {
  const holder = h("span", { class: "bounds" });
  const inner = (): JsonObject => (isObject(place.get()) ? (place.get() as JsonObject) : {});
  const one = (words: string, value: () => Json | undefined, put: (value: Json | undefined) => void): HTMLElement => {
    const now = value();
    const input = h("input", {
      type: "text",
      class: "figure",
      inputMode: "decimal",
      "aria-label": `${name}, ${words}`,
      value: shown(now),
      oninput: () => {
        put(input.value === "" ? undefined : figureOf(input.value));
        for (const other of holder.querySelectorAll("input"))
          if (other !== input && Boolean(other.dataset.alone) !== Boolean(input.dataset.alone)) other.value = "";
        setText(trade, typeof value() === "number" ? inTrade(schema.description ?? "", value() as number) : "");
        form.changed();
      },
    });
    if (words === kAtLeast) input.dataset.alone = "1";
    const trade = h(
      "span",
      { class: "trade quiet" },
      typeof now === "number" ? inTrade(schema.description ?? "", now) : "",
    );
    return h("label", {}, h("span", {}, words), input, trade);
  };
  holder.append(
    one(
      kAtLeast,
      () => (isObject(place.get()) ? undefined : place.get()),
      (value) => place.set(value),
    ),
    ...Object.keys(schema.properties ?? {}).map((key) =>
      one(
        key,
        () => inner()[key],
        (value) => {
          const next = { ...inner() };
          if (value === undefined) delete next[key];
          else next[key] = value;
          place.set(next);
        },
      ),
    ),
  );
  return [holder];
}

/** The control of a field that isPlain(). */
export function plainControl(schema: Schema, place: Place, form: Form, name: string): HTMLElement[] {
  const types = typesOf(schema);
  const taken = form.takenOver(place.pointer) ?? schema.default;
  const otherwise = taken === undefined ? "\u2013" : `(${label(shown(taken))})`;
  if (schema.enum)
    return [
      choice(
        schema.enum.map((value) => [value, label(shown(value))]),
        place,
        form,
        name,
        otherwise,
      ),
    ];
  if (types.length === 1 && types[0] === "boolean")
    return [
      choice(
        [
          [true, t("yes")],
          [false, t("no")],
        ],
        place,
        form,
        name,
        taken === undefined ? "\u2013" : taken ? `(${t("yes")})` : `(${t("no")})`,
      ),
    ];
  if (types.includes("object")) return bounds(schema, place, form, name);
  if (types.includes("array")) return names(schema, place, form, name);
  return typed(schema, place, form, name);
}

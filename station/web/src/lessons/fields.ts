// A form made of a schema: every field that a value has, a choice of those that it may have, lists to which one adds.

import { h } from "../kit/dom";
import type { Form } from "./form";
import { type Json, type JsonObject, type Place, isObject, isScalar, placeIn, scalarText } from "./json";
import { plainControl } from "./plain_fields";
import { type Schema, blank, isPlain, label, meaning, quantities, resolved, typesOf } from "./schema";
import { t } from "../kit/language";

const kHint = 110; // characters of a description in a choice

const button = (text: string, name: string, act: () => void): HTMLButtonElement =>
  h("button", { type: "button", class: "plain small", "aria-label": name, title: name, onclick: act }, text);

/** A line of a form. remove: takes the field away; undefined: it stays. */
function line(
  schema: Schema,
  place: Place,
  form: Form,
  name: string,
  context: string,
  remove?: () => void,
): HTMLElement {
  return h(
    "div",
    { class: "field", "data-at": place.pointer },
    h("span", { class: "label" }, label(name)),
    h("span", { class: "control" }, ...plainControl(schema, place, form, `${context}${label(name)}`)),
    h("span", { class: "hint quiet" }, meaning(schema)),
    remove && button("\u00d7", t("take away {what}", { what: `${context}${label(name)}` }), remove),
  );
}

/** A field of an object, whatever it is. */
function field(
  schema: Schema,
  place: Place,
  form: Form,
  name: string,
  context: string,
  remove?: () => void,
): HTMLElement {
  if (isPlain(schema)) return line(schema, place, form, name, context, remove);
  return h(
    "fieldset",
    { class: "part", "data-at": place.pointer },
    h(
      "legend",
      {},
      label(name),
      remove && button("\u00d7", t("take away {what}", { what: `${context}${label(name)}` }), remove),
    ),
    h("p", { class: "hint quiet" }, schema.description ?? ""),
    part(schema, place, form, `${context}${label(name)}: `),
  );
}

/** What a field of a criterion is measured in: that of the figure that is limited. */
function withUnit(name: string, schema: Schema, holder: Json | undefined): Schema {
  const unit =
    isObject(holder) && ["min", "max", "fail_below", "fail_above"].includes(name)
      ? quantities.get(scalarText(holder.of))
      : undefined;
  return unit ? { ...schema, description: `${unit}; ${schema.description}` } : schema;
}

/**
 * The fields of an object: those that it has or must have, and a choice of the others. all: the plain ones are all
 * shown.
 */
export function objectFields(schema: Schema, place: Place, form: Form, context: string, all = false): HTMLElement {
  const element = h("div", { class: "fields" });
  const draw = (): void => {
    const value = place.get();
    const has = (name: string): boolean => isObject(value) && name in value;
    const entries = Object.entries(schema.properties ?? {})
      .filter(([name]) => name !== "$schema")
      .map(([name, inner]) => [name, withUnit(name, resolved(inner), value)] as const);
    const must = (name: string): boolean => (schema.required ?? []).includes(name);
    const inSight = entries.filter(([name, inner]) => has(name) || must(name) || (all && isPlain(inner)));
    const others = entries.filter((entry) => !inSight.includes(entry));
    const remove = (name: string) => (): void => {
      placeIn(place, name).set(undefined);
      draw();
      form.changed();
    };
    element.replaceChildren(
      ...inSight.map(([name, inner]) =>
        field(
          inner,
          placeIn(place, name),
          form,
          name,
          context,
          has(name) && !must(name) && !(all && isPlain(inner)) ? remove(name) : undefined,
        ),
      ),
    );
    if (others.length === 0) return;
    const add = h("select", {
      class: "add",
      "aria-label": `${context}${t("add a field")}`,
      onchange: () => {
        const name = add.value;
        placeIn(place, name).set(blank(resolved(schema.properties![name]!)));
        draw();
        form.changed();
      },
    });
    add.append(
      h("option", { value: "" }, t("add \u2026")),
      ...others.map(([name, inner]) =>
        h("option", { value: name }, `${label(name)}: ${meaning(inner).slice(0, kHint)}`),
      ),
    );
    element.append(add);
  };
  draw();
  return element;
}

/** "fall, limit, cable_speed": what tells an entry from the others. */
function summary(value: Json | undefined): string {
  if (!isObject(value)) return value === undefined ? "" : JSON.stringify(value);
  const words = Object.entries(value)
    .filter(([name, each]) => isScalar(each) && name !== "why" && name !== "text")
    .map(([, each]) => scalarText(each));
  const text = value.text ?? value.why;
  return [...words.slice(0, 4), ...(typeof text === "string" ? [text] : [])].join(", ");
}

/** The list with some of its entries taken out at a place, and others put in. */
function spliced(list: readonly Json[], place: number, out: number, ...put: Json[]): Json[] {
  const next = [...list];
  next.splice(place, out, ...put);
  return next;
}

/** A list of objects: each a card that opens; added, copied, moved, taken away. */
function listFields(schema: Schema, place: Place, form: Form, context: string): HTMLElement {
  const element = h("div", { class: "list" });
  const items = resolved(schema.items ?? {});
  const draw = (open = -1): void => {
    const given = place.get();
    const list = Array.isArray(given) ? given : [];
    const change = (shown: number, next: Json[]): void => {
      place.set(next);
      draw(shown);
      form.changed();
    };
    const taken = form.takenOver(place.pointer);
    const inherits = given === undefined && Array.isArray(taken) && taken.length > 0;
    element.replaceChildren(
      ...list.map((value, i) => {
        const name = `${context}${t("entry {number}", { number: i + 1 })}`;
        const entry = placeIn(place, i);
        const words = h("span", { class: "summary" }, summary(value));
        const card = h(
          "details",
          { class: "card", open: i === open, "data-at": entry.pointer },
          h("summary", {}, h("b", {}, `${i + 1}`), words),
          h(
            "div",
            { class: "tools" },
            button(
              "\u2191",
              `${name}: ${t("up|in a list")}`,
              () => i > 0 && change(i - 1, spliced(list, i - 1, 2, value, list[i - 1]!)),
            ),
            button(
              "\u2193",
              `${name}: ${t("down|in a list")}`,
              () => i + 1 < list.length && change(i + 1, spliced(list, i, 2, list[i + 1]!, value)),
            ),
            button(t("copy"), `${name}: ${t("copy")}`, () =>
              change(i + 1, spliced(list, i + 1, 0, copyOf(value, list))),
            ),
            button(t("add after"), `${name}: ${t("add after")}`, () =>
              change(i + 1, spliced(list, i + 1, 0, blank(items))),
            ),
            button(t("take away"), `${name}: ${t("take away")}`, () => change(-1, spliced(list, i, 1))),
          ),
          part(items, entry, form, `${context}${(isObject(value) && scalarText(value.id)) || i + 1}: `),
        );
        card.addEventListener("input", () => (words.textContent = summary(entry.get())));
        return card;
      }),
      ...(inherits
        ? [
            h(
              "p",
              { class: "quiet" },
              `${t("{count} taken over:", { count: taken.length })} `,
              ...taken.map((each) => h("span", { class: "taken" }, summary(each))),
            ),
            button(t("change them here"), `${context}${t("change them here")}`, () =>
              change(0, structuredClone(taken)),
            ),
          ]
        : []),
      button(t("add"), `${context}${t("add an entry")}`, () => change(list.length, [...list, blank(items)])),
    );
  };
  draw();
  return element;
}

/** A copy with a name of its own. */
function copyOf(value: Json, list: Json[]): Json {
  const copy = structuredClone(value);
  if (!isObject(copy) || typeof copy.id !== "string") return copy;
  const taken = new Set(list.map((each) => (isObject(each) ? each.id : undefined)));
  const { id } = copy;
  for (let i = 2; taken.has(copy.id); ++i) copy.id = `${id}-${i}`;
  return copy;
}

/** Entries by a name of the writer's own. */
function namedFields(inner: Schema, place: Place, form: Form, context: string): HTMLElement {
  const element = h("div", { class: "list" });
  const draw = (): void => {
    const value = isObject(place.get()) ? (place.get() as JsonObject) : {};
    const name = h("input", {
      type: "text",
      class: "names",
      "aria-label": `${context}${t("name of a new one")}`,
      placeholder: t("name|of an entry"),
    });
    const rename = (from: string, to: string): void => {
      if (!to || to in value) return;
      place.set(Object.fromEntries(Object.entries(value).map(([key, each]) => [key === from ? to : key, each])));
      draw();
      form.changed();
    };
    element.replaceChildren(
      ...Object.keys(value).map((key) => {
        const own = h("input", {
          type: "text",
          class: "names",
          value: key,
          "aria-label": `${context}${t("name of {key}", { key })}`,
          onchange: () => rename(key, own.value.trim()),
        });
        const entry = placeIn(place, key);
        return h(
          "fieldset",
          { class: "part", "data-at": entry.pointer },
          h(
            "legend",
            {},
            own,
            button("\u00d7", t("take away {what}", { what: `${context}${key}` }), () => {
              entry.set(undefined);
              draw();
              form.changed();
            }),
          ),
          part(inner, entry, form, `${context}${key}: `),
        );
      }),
      h(
        "span",
        { class: "tools" },
        name,
        button(t("add"), `${context}${t("add it")}`, () => {
          const key = name.value.trim();
          if (!key || key in value) return;
          placeIn(place, key).set({});
          draw();
          form.changed();
        }),
      ),
    );
  };
  draw();
  return element;
}

/** What no form is made of, e.g. a grid of heights: its JSON. */
function raw(place: Place, form: Form, context: string): HTMLElement {
  const input = h("textarea", {
    rows: 4,
    "aria-label": `${context}${t("as JSON")}`,
    value: place.get() === undefined ? "" : JSON.stringify(place.get()),
    oninput: () => {
      try {
        place.set(input.value.trim() ? (JSON.parse(input.value) as Json) : undefined);
      } catch {
        place.set(input.value); // a text where none is allowed: the station says so
      }
      form.changed();
    },
  });
  return h("span", { class: "control" }, input);
}

/** The inside of an object or a list. */
export function part(schema: Schema, place: Place, form: Form, context: string): HTMLElement {
  if (schema.properties) return objectFields(schema, place, form, context);
  if (typesOf(schema).includes("array") && resolved(schema.items ?? {}).properties)
    return listFields(schema, place, form, context);
  if (typeof schema.additionalProperties === "object")
    return namedFields(resolved(schema.additionalProperties), place, form, context);
  return raw(place, form, context);
}

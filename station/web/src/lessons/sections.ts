// The form's sections, as the schemas have them: first what is taught, then where.

import { h, setAttribute } from "../kit/dom";
import { objectFields, part } from "./fields";
import { type Form, type Mistake, placeOf } from "./form";
import { type JsonObject, type Place, placeIn, scalarText, wholeOf } from "./json";
import { type Schema, exerciseSchema, isPlain, label, lessonSchema, resolved } from "./schema";
import { t } from "../kit/language";

interface Section {
  title: string;
  group: "Lesson" | "Exercise";
  /** Of what is drawn in it. */
  pointer: string;
  /** Whether the mistake of that pointer is shown in it. */
  has: (pointer: string) => boolean;
  draw: (form: Form) => HTMLElement;
}

const within = (pointer: string, root: string): boolean => pointer === root || pointer.startsWith(`${root}/`);

/** How the groups are called. */
const groups = { Lesson: t("Lesson"), Exercise: t("Exercise") };

/** The plain fields of an object as one section, each of its parts as another. */
function sectionsOf(
  group: Section["group"],
  schema: Schema,
  root: string,
  find: (document: JsonObject) => Place,
  first: string,
): Section[] {
  const fields = Object.entries(schema.properties!).filter(
    ([name]) => name !== "$schema" && !(root === "" && name === "lesson"),
  );
  const parts = fields.filter(([, inner]) => !isPlain(resolved(inner)));
  const plain: Schema = { ...schema, properties: Object.fromEntries(fields.filter((each) => !parts.includes(each))) };
  return [
    {
      title: first,
      group,
      pointer: root,
      has: (pointer) =>
        within(pointer, root) &&
        !parts.some(([name]) => within(pointer, `${root}/${name}`)) &&
        !(root === "" && within(pointer, "/lesson")),
      draw: (form) => objectFields(plain, find(form.document), form, "", true),
    },
    ...parts.map(([name, reference]): Section => {
      const inner = resolved(reference);
      return {
        title: label(name),
        group,
        pointer: `${root}/${name}`,
        has: (pointer) => within(pointer, `${root}/${name}`),
        draw: (form) => {
          const place = placeIn(find(form.document), name);
          const ownFile = "from" in (inner.properties ?? {}); // what it leaves out stands in a file of its own
          return h(
            "div",
            {},
            inner.description && h("p", { class: "quiet" }, inner.description),
            inner.properties
              ? objectFields(inner, place, form, `${label(name)}: `, !ownFile)
              : part(inner, place, form, `${label(name)}: `),
          );
        },
      };
    }),
  ];
}

const sections: readonly Section[] = [
  ...sectionsOf("Lesson", lessonSchema, "/lesson", (document) => placeIn(wholeOf(document), "lesson"), t("Briefing")),
  ...sectionsOf("Exercise", exerciseSchema, "", wholeOf, t("Name and title")),
];

/** The form of a document with a bar of its sections; one is shown at a time, as long as the page is open the same. */
export class Sections {
  readonly bar = h("nav", { class: "sections", "aria-label": t("sections") });
  readonly element = h("div", { class: "form" });
  private form: Form | undefined;
  private chosen = 0;
  private mistakes: readonly Mistake[] = [];
  private readonly buttons: HTMLButtonElement[] = [];
  private readonly panels: HTMLElement[] = [];

  /** Draws the form of its document anew; of the same document what was open stays open. */
  show(form: Form): void {
    const open =
      form === this.form
        ? [...this.element.querySelectorAll<HTMLElement>("details[open]")].map((card) => card.dataset.at)
        : [];
    this.form = form;
    this.buttons.length = this.panels.length = 0;
    this.bar.replaceChildren();
    for (const group of ["Lesson", "Exercise"] as const) {
      this.bar.append(h("h3", {}, groups[group]));
      const taught = group === "Exercise" || "lesson" in form.document;
      sections.forEach((section, i) => {
        if (section.group !== group || !taught) return;
        this.buttons[i] = h(
          "button",
          { type: "button", class: "plain", onclick: () => this.choose(i) },
          h("span", {}, section.title),
          h("b", { class: "count" }),
        );
        this.bar.append(this.buttons[i]);
        this.panels[i] = h(
          "section",
          { hidden: true, "aria-label": section.title, "data-at": section.pointer },
          h("h2", {}, `${groups[group]}: ${section.title}`),
          section.draw(form),
        );
      });
      if (!taught)
        this.bar.append(
          h(
            "button",
            {
              type: "button",
              class: "plain",
              onclick: () => {
                form.document.lesson = { id: scalarText(form.document.name) || "new", criteria: [] };
                this.chosen = 0;
                this.show(form);
                form.changed();
              },
            },
            t("Make it a lesson"),
          ),
        );
    }
    this.element.replaceChildren(...this.panels.filter(Boolean));
    for (const card of this.element.querySelectorAll("details")) card.open = open.includes(card.dataset.at);
    this.choose(this.panels[this.chosen] ? this.chosen : this.panels.findIndex(Boolean));
  }

  choose(i: number): void {
    this.chosen = i;
    this.panels.forEach((panel, k) => (panel.hidden = k !== i));
    this.buttons.forEach((button, k) => setAttribute(button, "aria-current", k === i ? "true" : undefined));
    this.element.scrollTop = 0;
  }

  /** Each mistake at its field, and how many each section has. */
  tell(mistakes: readonly Mistake[] = this.mistakes): void {
    this.mistakes = mistakes;
    this.form?.tell(this.element, mistakes);
    this.buttons.forEach((button, i) => {
      const count = mistakes.filter((mistake) => sections[i]!.has(mistake.at)).length;
      button.querySelector(".count")!.textContent = count ? `${count}` : "";
    });
  }

  /** Brings the field of a mistake into sight. */
  goTo(mistake: Mistake): void {
    const i = sections.findIndex((section) => section.has(mistake.at));
    if (this.panels[i]) this.choose(i);
    const place = placeOf(this.element, mistake.at);
    for (let around = place ?? null; around; around = around.parentElement)
      if (around instanceof HTMLDetailsElement) around.open = true;
    place?.scrollIntoView({ block: "center" });
    (place?.querySelector("input, select, textarea") as HTMLElement | null)?.focus();
  }
}

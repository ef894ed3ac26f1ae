// The page of lessons: which there are, one of them as a form, checked as it is changed, saved, loaded into an
// exercise.

import { orderIn } from "../classroom/exercise_order";
import { h, setText } from "../kit/dom";
import { holdButton } from "../kit/hold_button";
import { type Page, pageAddress } from "../kit/page";
import { ExerciseFiles, type Checked, type Listing } from "./files";
import { Form } from "./form";
import { type JsonObject, placeWords, textOf } from "./json";
import { Sections } from "./sections";
import { t } from "../kit/language";

const kDraft = "windlass.lesson"; // what is not saved yet, in this browser
const kQuiet = 400; // ms without a change before it is checked

interface Draft {
  name: string;
  text: string;
  /** Of the file as it was opened; "": there was none. */
  stamp: string;
}

class Editor {
  private readonly files: ExerciseFiles;
  private readonly sections = new Sections();
  private readonly list = h("ul", { class: "files" });
  private readonly notice = h("p", { class: "notice", role: "status", "aria-live": "polite" });
  private readonly name = h("input", {
    type: "text",
    "aria-label": t("file name"),
    maxLength: 64,
    spellcheck: false,
    oninput: () => this.showSaving(),
  });
  private readonly told = h("ol", { class: "told", "aria-label": t("mistakes") });
  private readonly verdict = h("p", { class: "verdict", role: "status" });
  private readonly save = h(
    "button",
    { type: "button", class: "plain primary", onclick: () => void this.store("") },
    t("Save as new"),
  );
  private readonly over = holdButton(t("Save over"), 0.8, () => void this.store(this.opened.stamp), { class: "plain" });
  private readonly into = h("select", { "aria-label": t("exercise to load it into") });
  private readonly practice = h("input", { type: "checkbox" });
  private readonly load = holdButton(t("Load"), 0.8, () => void this.loadInto(), { class: "plain" });
  private readonly desk = h("a", { class: "button", hidden: true }, t("Desk"));
  private names: Listing = { files: [], events: [], faults: [] };
  private form: Form | undefined;
  private opened: Draft = { name: "", text: "", stamp: "" };
  private saved = ""; // text that the file has
  private stale = false; // other values are taken over than are shown
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly page: Page) {
    this.files = new ExerciseFiles(page.link);
    page.topBar.middle.append(
      h("a", { class: "plain", href: pageAddress("/classroom") }, t("Classroom")),
      h("a", { class: "plain", href: pageAddress("/instructor") }, t("Desk")),
    );
    page.root.classList.add("lessons");
    page.root.append(
      h(
        "section",
        { class: "panel choose", "aria-label": t("exercises") },
        h("h2", {}, t("Lessons and exercises")),
        this.list,
      ),
      this.sections.bar,
      h(
        "section",
        { class: "editor panel", "aria-label": t("the exercise") },
        h(
          "div",
          { class: "bar", role: "toolbar", "aria-label": t("file") },
          h("label", { class: "row" }, t("file"), this.name),
          this.save,
          this.over,
          h("span", { class: "gap" }),
          h("label", { class: "row" }, t("into"), this.into),
          h("label", { class: "row" }, this.practice, t("for practice, with hints")),
          this.load,
          this.desk,
        ),
        this.notice,
        this.verdict,
        this.told,
        this.sections.element,
      ),
    );
    page.link.onState((state) => state === "open" && void this.showList());
    page.link.onMessage("hello", () => this.showExercises());
    this.sections.element.addEventListener("focusout", (event) => {
      if (!this.stale || this.sections.element.contains(event.relatedTarget as Node | null)) return;
      this.showTakenOver();
      this.sections.tell();
    });
    this.showExercises();
    this.showSaving();
    const draft = localStorage.getItem(kDraft);
    if (draft) this.take(JSON.parse(draft) as Draft, "");
    else
      setText(
        this.verdict,
        t("Choose an exercise; a change is checked as it is made, and nothing is written before it is saved."),
      );
  }

  /** Whatever the station refuses is said. */
  private async tried<T>(work: Promise<T>): Promise<T | undefined> {
    setText(this.notice, "");
    try {
      return await work;
    } catch (why) {
      setText(this.notice, (why as Error).message);
      return undefined;
    }
  }

  private async showList(): Promise<void> {
    const listing = await this.tried(this.files.list());
    if (!listing) return;
    const first = this.names.events.length === 0;
    this.names = listing;
    const entry = ({ name, title, lesson }: Listing["files"][number]): HTMLElement =>
      h(
        "li",
        {},
        h(
          "button",
          { type: "button", class: "plain", "data-name": name, onclick: () => void this.open(name) },
          h("b", {}, lesson ?? name),
          h("span", {}, title || (lesson ? name : "")),
        ),
      );
    this.list.replaceChildren(
      ...listing.files.filter((file) => file.lesson !== null).map(entry),
      h("li", { class: "head quiet" }, t("without a lesson")),
      ...listing.files.filter((file) => file.lesson === null).map(entry),
    );
    if (first && this.form) this.draw(JSON.parse(this.opened.text) as JsonObject); // names to offer have come
  }

  private async open(name: string): Promise<void> {
    if (this.changed() && !confirm(t("{name} has changes that are not saved. Leave them?", { name: this.opened.name })))
      return;
    const read = await this.tried(this.files.read(name));
    if (read) this.take({ name, text: read.text, stamp: read.stamp }, read.text, read);
  }

  private take(draft: Draft, saved: string, checked?: Checked): void {
    const document = JSON.parse(draft.text) as JsonObject;
    this.opened = { ...draft, text: textOf(document) };
    this.saved = saved ? textOf(JSON.parse(saved) as JsonObject) : "";
    this.name.value = draft.name;
    this.desk.hidden = true;
    if (checked) localStorage.removeItem(kDraft);
    this.draw(document, checked);
  }

  private draw(document: JsonObject, checked?: Checked): void {
    const form = new Form(document, this.names, () => this.edited());
    if (this.form) form.inherited = this.form.inherited;
    if (checked) form.inherited = checked.inherited;
    this.form = form;
    this.sections.show(form);
    this.showSaving();
    if (checked) this.tell(checked);
    else this.edited();
  }

  private changed(): boolean {
    return this.form !== undefined && this.opened.text !== this.saved;
  }

  private edited(): void {
    this.opened.text = textOf(this.form!.document);
    localStorage.setItem(kDraft, JSON.stringify({ ...this.opened, name: this.name.value }));
    this.showSaving();
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.check(), kQuiet);
  }

  private async check(): Promise<void> {
    if (this.page.link.state !== "open") return void (this.timer = setTimeout(() => void this.check(), kQuiet));
    const { text } = this.opened;
    const checked = await this.tried(this.files.check("", text));
    if (checked && text === this.opened.text) this.tell(checked);
  }

  private tell({ mistakes, doubts, inherited }: Checked): void {
    const form = this.form!;
    this.stale ||= inherited !== null && JSON.stringify(form.inherited) !== JSON.stringify(inherited);
    form.inherited = inherited;
    if (!this.sections.element.contains(document.activeElement)) this.showTakenOver();
    this.sections.tell(mistakes);
    this.verdict.dataset.sound = `${mistakes.length === 0}`;
    setText(
      this.verdict,
      mistakes.length
        ? mistakes.length === 1
          ? t("1 mistake: it can be saved once there is none")
          : t("{count} mistakes: it can be saved once there is none", { count: mistakes.length })
        : t("Sound."),
    );
    this.told.replaceChildren(
      ...mistakes.map((mistake) =>
        h(
          "li",
          {},
          h(
            "button",
            { type: "button", class: "plain", onclick: () => this.sections.goTo(mistake) },
            h("b", { title: mistake.at }, placeWords(form.document, mistake.at)),
            ` ${mistake.text}`,
          ),
        ),
      ),
      ...doubts.map((doubt) =>
        h("li", { class: "quiet" }, t("may be a mistake: {doubt}", { doubt: doubt.replace("/lesson/", "") })),
      ),
    );
  }

  /** Shows other values that are taken over, once nobody is typing. */
  private showTakenOver(): void {
    if (this.stale) this.sections.show(this.form!);
    this.stale = false;
  }

  private async store(over: string): Promise<void> {
    if (!this.form) return;
    const name = this.name.value.trim();
    const { text } = this.opened;
    const answer = await this.tried(this.files.save(name, text, over));
    if (!answer) return;
    this.tell(answer);
    if (!answer.saved) return setText(this.notice, t("Not saved: it has mistakes."));
    localStorage.removeItem(kDraft);
    this.opened = { name, text: this.opened.text, stamp: answer.stamp };
    this.saved = text;
    this.showSaving();
    await this.showList();
    setText(this.notice, t("Saved as {name}.", { name }));
  }

  private showSaving(): void {
    const own = this.opened.stamp !== "" && this.name.value.trim() === this.opened.name;
    this.save.hidden = own;
    this.over.hidden = !own;
    this.save.disabled = this.over.disabled = !this.form;
    this.load.disabled = !this.form || this.changed() || !own;
    this.load.title = this.load.disabled ? t("save it first") : t("hold for 0.8 s: the exercise that runs there ends");
  }

  private showExercises(): void {
    const hello = this.page.link.hello;
    const names = hello ? [...new Set([...hello.live, hello.exercise])] : [];
    if (names.join() === [...this.into.options].map((option) => option.value).join()) return;
    const chosen = this.into.value || (hello?.exercise ?? "");
    this.into.replaceChildren(...names.map((name) => h("option", { value: name }, name)));
    if (names.includes(chosen)) this.into.value = chosen;
  }

  private async loadInto(): Promise<void> {
    const exercise = this.into.value;
    const given = await this.tried(
      orderIn(exercise, "ExerciseCommand", {
        action: "EXERCISE_LOAD",
        exercise: this.opened.name,
        practice: this.practice.checked,
      }).then(() => true),
    );
    if (!given) return;
    setText(
      this.notice,
      t("{name} is being loaded into {exercise}: start it at its desk.", { name: this.opened.name, exercise }),
    );
    this.desk.href = pageAddress("/instructor", { exercise });
    this.desk.hidden = false;
  }
}

export function makeEditor(page: Page): void {
  new Editor(page);
}

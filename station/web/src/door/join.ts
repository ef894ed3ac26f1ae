// A trainee comes in: the code of the class, and a name.

import { h, setText } from "../kit/dom";
import { type Me, act, ask } from "./ask";
import { doorSaid } from "./door_sentences";
import { field, form } from "./form";
import { frame } from "./frame";
import { showKeptMarks } from "../kit/kept_marks";
import { t } from "../kit/language";
import { capital } from "../kit/words";
import { whySentAway } from "../wire/connection";

const kLetters = 6; // of a code

export function makeJoin(): void {
  const root = frame(t("Join a class"));
  const given = new URLSearchParams(location.search).get("code") ?? "";
  const code = h("input", {
    name: "code",
    class: "code",
    required: true,
    autocomplete: "off",
    autocapitalize: "characters",
    spellcheck: false,
    maxLength: 12,
    value: given,
  });
  const name = h("input", { name: "name", required: true, maxLength: 32, autocomplete: "nickname" });
  const listed = h("select", {
    name: "listed",
    "aria-label": t("Your name"),
    required: true,
    hidden: true,
    disabled: true,
  });
  /** A class that has a list offers it. */
  const offer = async (): Promise<void> => {
    if (code.value.replace(/\W/g, "").length < kLetters) return;
    const { names } = await act<{ names: string[] | null }>("names", { code: code.value });
    const typed = names === null;
    name.hidden = name.disabled = !typed;
    listed.hidden = listed.disabled = typed;
    const choose = h("option", { value: "" }, t("choose your name")); // who is in haste is not the first of the list
    listed.replaceChildren(choose, ...(names ?? []).map((each) => h("option", { value: each }, each)));
  };
  /** Of a code that was refused already: told when a seat is asked for, and not asked twice, since each counts. */
  let refused: { code: string; why: Error } | undefined;
  let looked = Promise.resolve();
  const look = (): void => {
    refused = undefined;
    looked = offer().catch((why: Error) => void (refused = { code: code.value, why }));
  };
  code.onchange = look;
  const setup = h(
    "p",
    { class: "quiet", hidden: true },
    t("Nobody is set up yet: the door's program has printed a link."),
  );
  const sentAway = h("p", { class: "notice", role: "status" }, capital(doorSaid(whySentAway())));
  // It is of the class before: who begins the form is at another one.
  for (const begun of [code, name, listed]) begun.addEventListener("input", () => setText(sentAway, ""));
  root.append(
    h(
      "div",
      { class: "narrow" },
      sentAway,
      form(
        t("Take a seat"),
        [
          field(t("Code of the class"), code, t("six letters, from your instructor")),
          field(t("Your name"), h("div", {}, name, listed)),
        ],
        async () => {
          await looked;
          const earlier = refused;
          refused = undefined;
          if (earlier?.code === code.value) throw earlier.why;
          await act("join", { code: code.value, name: name.disabled ? listed.value : name.value });
          location.assign("/");
        },
      ),
      h(
        "p",
        { class: "ways" },
        h("a", { href: "/login" }, t("Instructors log in")),
        h("a", { href: "/trust" }, t("Is this the right machine?")),
      ),
      setup,
    ),
  );
  (given ? name : code).focus();
  look();
  showKeptMarks();
  void ask<Me>("me").then((me) => (setup.hidden = !me.setup));
}

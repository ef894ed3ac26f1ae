// A trainee comes in: the code of the class, and a name.

import { h } from "../kit/dom";
import { type Me, act, ask } from "./ask";
import { field, form, frame } from "./frame";

export function makeJoin(): void {
  const root = frame("Join a class");
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
  const setup = h(
    "p",
    { class: "quiet", hidden: true },
    "Nobody is set up yet: the door's program has printed a link.",
  );
  root.append(
    h(
      "div",
      { class: "narrow" },
      form(
        "Take a seat",
        [field("Code of the class", code, "six letters, from your instructor"), field("Your name", name)],
        async () => {
          await act("join", { code: code.value, name: name.value });
          location.assign("/");
        },
      ),
      h(
        "p",
        { class: "ways" },
        h("a", { href: "/login" }, "Instructors log in"),
        h("a", { href: "/trust" }, "Is this the right machine?"),
      ),
      setup,
    ),
  );
  (given ? name : code).focus();
  void ask<Me>("me").then((me) => (setup.hidden = !me.setup));
}

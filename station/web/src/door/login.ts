// Instructors log in; the first owner is set up.

import { h } from "../kit/dom";
import { act } from "./ask";
import { field, form } from "./form";
import { frame } from "./frame";
import { t } from "../kit/language";

const nameInput = (): HTMLInputElement =>
  h("input", { name: "name", required: true, maxLength: 32, autocomplete: "username" });

export function makeLogin(): void {
  const root = frame(t("Log in"));
  const name = nameInput();
  const password = h("input", { name: "password", type: "password", required: true, autocomplete: "current-password" });
  root.append(
    h(
      "div",
      { class: "narrow" },
      form(t("Log in"), [field(t("Name"), name), field(t("Password"), password)], async () => {
        await act("login", { name: name.value, password: password.value });
        location.assign("/class");
      }),
      h("p", { class: "ways" }, h("a", { href: "/" }, t("Join a class as a trainee"))),
    ),
  );
  name.focus();
}

export function makeSetup(): void {
  const root = frame(t("Set up"));
  const token = new URLSearchParams(location.hash.slice(1)).get("token") ?? "";
  history.replaceState(null, "", location.pathname); // it is nobody's who looks over a shoulder
  const name = nameInput();
  const password = h("input", {
    name: "password",
    type: "password",
    required: true,
    minLength: 10,
    autocomplete: "new-password",
  });
  const again = h("input", { type: "password", required: true, autocomplete: "new-password" });
  root.append(
    h(
      "div",
      { class: "narrow" },
      h("p", {}, t("The first owner lets other instructors in, makes classes, and looks after this machine's log.")),
      form(
        t("Set up"),
        [
          field(t("Your name"), name),
          field(t("Password"), password, t("10 characters at least")),
          field(t("The password again"), again),
        ],
        async () => {
          if (password.value !== again.value) throw new Error(t("The two passwords differ"));
          await act("setup", { token, name: name.value, password: password.value });
          location.assign("/class");
        },
      ),
    ),
  );
  name.focus();
}

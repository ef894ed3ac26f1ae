// Who may log in: an owner's page.

import { h } from "../kit/dom";
import { holdButton } from "../kit/hold_button";
import { act, ask } from "./ask";
import { field, form } from "./form";
import { frame } from "./frame";
import { t, translated } from "../kit/language";

interface People {
  people: { name: string; rank: string }[];
}

const ranks: [string, string][] = [
  ["instructor", t("classes, orders, faults")],
  ["assessor", t("looks on, marks too")],
  ["observer", t("looks on")],
  ["owner", t("and lets others in")],
];

export async function makePeople(): Promise<void> {
  const root = frame(t("People"), h("a", { href: "/class" }, t("Class")));
  const list = h("ul", { class: "people" });
  const show = ({ people }: People): void =>
    list.replaceChildren(
      ...people.map(({ name, rank }) =>
        h(
          "li",
          {},
          h("strong", {}, name),
          h("span", { class: "quiet" }, translated(rank)),
          holdButton(
            t("Remove"),
            1,
            () => void act<People>("people", { do: "remove", name }).then(show, (why: Error) => alert(why.message)),
            { class: "plain" },
          ),
        ),
      ),
    );
  const name = h("input", { required: true, maxLength: 32, autocomplete: "off" });
  const password = h("input", { type: "password", required: true, minLength: 10, autocomplete: "new-password" });
  const rank = h(
    "select",
    {},
    ...ranks.map(([value, what]) => h("option", { value }, `${translated(value)}: ${what}`)),
  );
  root.append(
    h(
      "div",
      { class: "narrow" },
      list,
      form(
        t("Let in"),
        [
          field(t("Name"), name),
          field(t("Rank"), rank),
          field(t("First password"), password, t("10 characters at least")),
        ],
        async () => {
          show(
            await act<People>("people", { do: "put", name: name.value, rank: rank.value, password: password.value }),
          );
          name.value = password.value = "";
        },
      ),
    ),
  );
  show(await ask<People>("people"));
}

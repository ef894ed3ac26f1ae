// Who may log in: an owner's page.

import { h } from "../kit/dom";
import { act, ask } from "./ask";
import { field, form, frame } from "./frame";

interface People {
  people: { name: string; rank: string }[];
}

const ranks: [string, string][] = [
  ["instructor", "classes, orders, faults"],
  ["assessor", "looks on, marks too"],
  ["observer", "looks on"],
  ["owner", "and lets others in"],
];

export async function makePeople(): Promise<void> {
  const root = frame("People", h("a", { href: "/class" }, "Class"));
  const list = h("ul", { class: "people" });
  const show = ({ people }: People): void =>
    list.replaceChildren(
      ...people.map(({ name, rank }) =>
        h(
          "li",
          {},
          h("strong", {}, name),
          h("span", { class: "quiet" }, rank),
          h(
            "button",
            {
              class: "plain",
              onclick: () =>
                act<People>("people", { do: "remove", name }).then(show, (why: Error) => alert(why.message)),
            },
            "Remove",
          ),
        ),
      ),
    );
  const name = h("input", { required: true, maxLength: 32, autocomplete: "off" });
  const password = h("input", { type: "password", required: true, minLength: 10, autocomplete: "new-password" });
  const rank = h("select", {}, ...ranks.map(([value, what]) => h("option", { value }, `${value}: ${what}`)));
  root.append(
    h(
      "div",
      { class: "narrow" },
      list,
      form(
        "Let in",
        [field("Name", name), field("Rank", rank), field("First password", password, "10 characters at least")],
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

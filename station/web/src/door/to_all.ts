// What an instructor gives to all exercises of a class at once: a fault, or words of the bridge.

import { faultForm } from "../desk/fault_form";
import { faults } from "../desk/fault_words";
import { h } from "../kit/dom";
import { TypedCount, kMostWords } from "../kit/typed_count";
import type { OrderSample } from "../wire/connection";
import { t, translated } from "../kit/language";

/** what: in words. Resolves whether it was taken. */
export type Give = (
  topic: "FaultCommand" | "BridgeOrderCommand",
  sample: OrderSample,
  what: string,
) => Promise<boolean>;

/** Buttons, each with a dialog of its own, which closes once what it gives was taken; refuse: what cannot be sent. */
export function toAll(give: Give, refuse: (text: string) => void): HTMLElement[] {
  return [button(t("Fault to all"), faultDialog(give, refuse)), button(t("Say to all"), wordsDialog(give))];
}

function button(text: string, dialog: HTMLDialogElement): HTMLElement {
  return h(
    "button",
    {
      onclick: () => {
        document.body.append(dialog);
        dialog.onclose = () => dialog.remove();
        dialog.showModal();
      },
    },
    text,
  );
}

const closing = (dialog: () => HTMLDialogElement): HTMLElement =>
  h("button", { class: "plain", type: "button", onclick: () => dialog().close() }, t("Close"));

function faultDialog(give: Give, refuse: (text: string) => void): HTMLDialogElement {
  const which = h(
    "select",
    { "aria-label": t("fault"), onchange: () => choose() },
    ...faults.map((fault) => h("option", { value: fault.const }, translated(fault.said))),
  );
  const form = h("div", {});
  const give1 = async (sample: OrderSample, what: string): Promise<void> => {
    if (await give("FaultCommand", sample, what)) dialog.close();
  };
  const choose = (): void => {
    const fault = faults.find((each) => each.const === which.value)!;
    const said = translated(fault.said);
    form.replaceChildren(
      faultForm(fault, 0, (sample) => void give1(sample, said), refuse),
      h(
        "button",
        {
          class: "plain",
          type: "button",
          onclick: () => void give1({ code: fault.enumerator, clear: true }, t("{fault} cleared", { fault: said })),
        },
        t("Clear it everywhere"),
      ),
    );
  };
  const dialog: HTMLDialogElement = h(
    "dialog",
    { class: "to-all", "aria-label": t("a fault to all") },
    h(
      "header",
      {},
      which,
      closing(() => dialog),
    ),
    form,
  );
  choose();
  return dialog;
}

function wordsDialog(give: Give): HTMLDialogElement {
  const words = h("input", { "aria-label": t("words to all"), required: true });
  const typed = new TypedCount(words, kMostWords.order);
  const send = async (event: Event): Promise<void> => {
    event.preventDefault();
    const sample = { code: "BRIDGE_ORDER_TEXT", side: -1, text: words.value.trim() };
    const what = t("“{words}” said", { words: sample.text });
    if (!sample.text || !(await give("BridgeOrderCommand", sample, what))) return;
    typed.clear();
    dialog.close();
  };
  const dialog: HTMLDialogElement = h(
    "dialog",
    { class: "to-all", "aria-label": t("words to all") },
    h(
      "form",
      { onsubmit: (event: Event) => void send(event) },
      h("p", {}, t("The bridge says it to every forecastle, where the VHF works.")),
      words,
      typed.element,
      h(
        "div",
        { class: "bar" },
        h("button", { class: "primary" }, t("Say it")),
        closing(() => dialog),
      ),
    ),
  );
  return dialog;
}

// Devices that stand at one seat: the owner makes an address for each, which is opened once on it.

import { h } from "../kit/dom";
import { t } from "../kit/language";
import { type PlaceName, act, ask, placeWords } from "./ask";
import { field, form } from "./form";
import { qr } from "./qr";

interface Kiosks {
  kiosks: { name: string; exercise: number; place: PlaceName; opened: boolean }[];
  /** Of the address that was made just now. */
  key?: string;
}

/** door: the address of the door as devices reach it, up to and with its last slash. */
export function kiosks(door: () => string): HTMLElement {
  const name = h("input", { name: "device", required: true, maxLength: 32, autocomplete: "off" });
  const exercise = h("input", { type: "number", required: true, min: 1, max: 64, value: "1" });
  const places: PlaceName[] = ["forecastle", "bridge", "ship", "watch"];
  const place = h("select", {}, ...places.map((each) => h("option", { value: each }, placeWords[each])));
  const made = h("section", { class: "panel kiosk-made", hidden: true, role: "status" });
  const list = h("ul", { class: "people" });
  const remove = (which: string): void => {
    made.hidden = true;
    void act<Kiosks>("kiosks", { do: "remove", name: which }).then(show, (why: Error) => alert(why.message));
  };
  const show = (told: Kiosks): void =>
    list.replaceChildren(
      ...told.kiosks.map((each) => {
        const seat = t("{place} of exercise {number}", { place: placeWords[each.place], number: each.exercise });
        const state = each.opened ? t("a device has it") : t("its address is not opened yet");
        return h(
          "li",
          {},
          h("strong", {}, each.name),
          h("span", { class: "quiet" }, `${seat}, ${state}`),
          h("button", { class: "plain", onclick: () => remove(each.name) }, t("Take it back")),
        );
      }),
    );
  const make = async (): Promise<void> => {
    const number = exercise.valueAsNumber;
    const told = await act<Kiosks>("kiosks", { do: "put", name: name.value, exercise: number, place: place.value });
    const address = `${door()}kiosk#key=${told.key ?? ""}`;
    made.hidden = false;
    made.replaceChildren(
      h("p", {}, t("Open this address once on {name}. It is shown here and nowhere else.", { name: name.value })),
      qr(address),
      h("code", {}, address),
    );
    name.value = "";
    show(told);
  };
  void ask<Kiosks>("kiosks").then(show);
  return h(
    "div",
    { class: "narrow" },
    h("h2", {}, t("Devices with a seat of their own")),
    h("p", {}, t("Such a computer or tablet is led to its seat of whatever class is under way, and waits before.")),
    form(
      t("Make an address"),
      [field(t("Name of the device"), name), field(t("Exercise, counted from 1"), exercise), field(t("Place"), place)],
      make,
    ),
    made,
    list,
  );
}

// A button for weighty acts: it acts when it was held down, not when it was touched. For those who cannot hold (a
// click made by assistive technology, which has no pointer), a second click within 3 s does the same.

import { h, setText } from "./dom";

const kAgain = 3000; // ms

/** seconds: how long to hold. The bar inside shows how far one is. */
export function holdButton(
  text: string,
  seconds: number,
  act: () => void,
  props: { [name: string]: unknown } = {},
): HTMLButtonElement {
  const words = h("span", {}, text);
  const button = h(
    "button",
    { title: `hold for ${seconds} s`, "aria-description": "hold to do it", ...props },
    h("i", { class: "held", style: `--hold: ${seconds}s`, "aria-hidden": "true" }),
    words,
  );
  button.classList.add("hold");
  let timer: ReturnType<typeof setTimeout> | undefined;
  const done = (): void => {
    timer = undefined;
    button.classList.remove("holding");
    act();
  };
  const press = (): void => {
    if (button.disabled || timer !== undefined) return;
    button.classList.add("holding");
    timer = setTimeout(done, seconds * 1000);
  };
  const release = (): void => {
    clearTimeout(timer);
    timer = undefined;
    button.classList.remove("holding");
  };
  const isPress = (event: KeyboardEvent): boolean => event.key === " " || event.key === "Enter";
  button.addEventListener("pointerdown", (event) => event.button === 0 && press());
  for (const end of ["pointerup", "pointerleave", "pointercancel", "blur", "contextmenu"])
    button.addEventListener(end, release);
  button.addEventListener("keydown", (event) => {
    if (!isPress(event)) return;
    event.preventDefault(); // no click of its own
    press();
  });
  button.addEventListener("keyup", (event) => isPress(event) && release());

  let armed: ReturnType<typeof setTimeout> | undefined;
  const disarm = (): void => {
    armed = undefined;
    setText(words, text);
  };
  button.addEventListener("click", (event) => {
    if (event.detail !== 0) return; // a pointer's: it has to be held
    if (armed === undefined) {
      setText(words, `${text}: again to confirm`);
      armed = setTimeout(disarm, kAgain);
    } else {
      clearTimeout(armed);
      disarm();
      act();
    }
  });
  return button;
}

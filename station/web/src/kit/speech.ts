// The browser's own voice, where it has one: what comes over the VHF is heard as well as read. A voice of this computer
// only: others send what they say to a service, and nothing leaves this computer unasked.

import { h, setAttribute, setText } from "./dom";
import { t } from "./language";

const kChosen = "windlass.voice";
const kWaiting = 2; // words that may wait: those of an exercise that is hurried are dropped, the newest is heard

export class Speech {
  /** Turns it on and off, and says which; hidden where the browser has no voice. */
  readonly button = h("button", { class: "plain voice", type: "button", hidden: true, onclick: () => this.toggle() });
  private readonly synthesis: SpeechSynthesis | undefined = window.speechSynthesis;
  private on = kept();
  private waiting = 0;

  constructor() {
    this.synthesis?.addEventListener?.("voiceschanged", () => this.show());
    this.show();
  }

  /** Says it behind what is being said; nothing while it is off. */
  say(words: string): void {
    const voice = this.voice();
    if (!this.synthesis || !this.on || !voice || !words) return;
    if (this.waiting > kWaiting) this.hush();
    const said = new SpeechSynthesisUtterance(words);
    said.voice = voice;
    said.lang = voice.lang;
    said.onend = said.onerror = () => (this.waiting = Math.max(0, this.waiting - 1));
    this.waiting += 1;
    this.synthesis.speak(said);
  }

  private voice(): SpeechSynthesisVoice | undefined {
    return this.synthesis?.getVoices().find(({ lang, localService }) => localService && /^en/i.test(lang));
  }

  private hush(): void {
    this.synthesis?.cancel();
    this.waiting = 0;
  }

  private toggle(): void {
    this.on = !this.on;
    if (!this.on) this.hush();
    try {
      localStorage.setItem(kChosen, this.on ? "on" : "off");
    } catch {
      // a browser that keeps nothing speaks all the same
    }
    this.show();
  }

  private show(): void {
    this.button.hidden = this.voice() === undefined;
    setText(this.button, this.on ? t("voice on") : t("voice off"));
    setAttribute(this.button, "aria-pressed", `${this.on}`);
  }
}

/** On, unless the user has turned it off. */
function kept(): boolean {
  try {
    return localStorage.getItem(kChosen) !== "off";
  } catch {
    return true;
  }
}

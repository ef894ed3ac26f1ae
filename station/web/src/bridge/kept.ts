// What a page keeps of a run by itself, so that it is there again when the page was loaded anew: plotted anchors, the
// watch circle, logs. In the browser's session only.

import type { Connection } from "../wire/connection";

export class Kept<T> {
  private value_: T;
  private run: string | undefined;
  private readonly listeners = new Set<(value: T) => void>();

  /**
   * name: of the entry; empty: what an exercise begins with; upTo: what of a value had happened at a time (s, exercise
   * time), for a run that goes on from there after a restore.
   */
  constructor(
    link: Connection,
    private readonly name: string,
    empty: () => T,
    upTo: (value: T, time: number) => T,
  ) {
    this.value_ = empty();
    link.on("ExerciseStatus", ({ run, exercise, time }) => {
      const key = `${link.hello?.exercise ?? exercise}/${run}`;
      if (key === this.run) return;
      const known = this.run !== undefined;
      this.run = key;
      if (known) this.value = upTo(this.value_, time);
      else {
        this.value_ = this.read() ?? empty();
        this.tell();
      }
    });
  }

  get value(): T {
    return this.value_;
  }
  set value(value: T) {
    this.value_ = value;
    if (this.run === undefined) return; // what a run keeps, comes with its first status
    try {
      sessionStorage.setItem(this.entry, JSON.stringify({ run: this.run, value }));
    } catch {
      // a browser that keeps nothing, or has no room, shows it all the same
    }
    this.tell();
  }

  /** Calls back when it changes, a new run included. */
  onChange(listener: (value: T) => void): void {
    this.listeners.add(listener);
  }

  private get entry(): string {
    return `windlass.bridge.${this.name}`;
  }

  private read(): T | undefined {
    try {
      const kept = JSON.parse(sessionStorage.getItem(this.entry) ?? "{}") as { run?: string; value?: T };
      return kept.run === this.run ? kept.value : undefined;
    } catch {
      return undefined;
    }
  }

  private tell(): void {
    for (const listener of this.listeners) listener(this.value_);
  }
}

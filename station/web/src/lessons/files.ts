// The exercise files of this station: asked one after the other.

import { type Connection, Refused } from "../wire/connection";
import type { Json } from "./json";
import type { Mistake, Names } from "./form";
import { t } from "../kit/language";

export interface FileEntry {
  name: string;
  title: string;
  /** Id of its lesson; null: it has none. */
  lesson: string | null;
}
export interface Listing extends Names {
  files: FileEntry[];
}
export interface Checked {
  mistakes: Mistake[];
  doubts: string[];
  inherited: Json;
}
export interface Opened extends Checked {
  text: string;
  stamp: string;
}
export interface Saved extends Checked {
  saved: boolean;
  stamp: string;
}

const kLargest = 16000; // bytes of a message that the station takes

export class ExerciseFiles {
  private last: Promise<unknown> = Promise.resolve();

  constructor(private readonly link: Connection) {}

  list = (): Promise<Listing> => this.ask({ what: "list" });
  read = (name: string): Promise<Opened> => this.ask({ what: "read", name });
  check = (name: string, text: string): Promise<Checked> => this.ask({ what: "check", name, text });
  /** over: stamp of the file that is replaced; "": there is none yet. */
  save = (name: string, text: string, over: string): Promise<Saved> => this.ask({ what: "save", name, text, over });

  private ask<T>(request: { [field: string]: string }): Promise<T> {
    const next = this.last.then(() => this.askNow<T>(request));
    this.last = next.catch(() => undefined);
    return next;
  }

  private async askNow<T>(request: { [field: string]: string }): Promise<T> {
    const message = { op: "exercise_files", ...request };
    const size = new TextEncoder().encode(JSON.stringify(message)).length;
    if (size > kLargest)
      throw new Refused(
        t("it has {size} bytes; {most} are allowed: put ship, windlass or ground into files of their own", {
          size,
          most: kLargest,
        }),
      );
    let answer: unknown;
    const end = this.link.onMessage("exercise_files", (heard) => (answer = heard));
    try {
      await this.link.ask(message);
    } finally {
      end();
    }
    return answer as T;
  }
}

// What tests put into a page's window, and what pages leave there for tests.

import type axe from "axe-core";

import type * as alarm from "../../station/web/src/sound/alarm";
import type * as chain from "../../station/web/src/sound/chain";
import type * as deck from "../../station/web/src/sound/deck";
import type * as samples from "../../station/web/src/sound/samples";
import type * as strikes from "../../station/web/src/sound/strikes";
import type * as voices from "../../station/web/src/sound/voices";
import type { Connection } from "../../station/web/src/wire/connection";

declare global {
  interface Window {
    /** When its script was run in the page. */
    axe: typeof axe;
    /** Of the forecastle's page. */
    windlass: { link: Connection; stats: () => { triangles: number; fps: number } | undefined };
    /** How often the page's loudspeaker became loud, and its context. */
    beeps: number;
    audio: AudioContext;
    /** A stand-in for navigator.getGamepads gives these. */
    pads: ((Partial<Omit<Gamepad, "buttons">> & { buttons: { pressed: boolean; value: number }[] }) | null)[];
    /** Shuts the page's socket, and lets no other open, until it is called with false. */
    cut: (on: boolean) => void;
    /** That the scene has drawn where the processor draws. */
    pictures: number;
    /** WebGL contexts that the page has made. */
    contexts: number;
    /** What the browser's voice has said, and the voices it has. */
    spoken: string[];
    voices: { name: string; lang: string; localService: boolean }[];
    /** How often the page has said that nothing is heard, or marked a panel as old. */
    silences: number;
    /** Words of the server since the test asked; 1 once they are counted. */
    told: number;
    words: number | undefined;
    /** The topic of which the page hears nothing more, see losing() of the silence's test. */
    lost: string;
    /** What was written on canvases, and how many points the longest track has. */
    written: Set<string>;
    trackPoints: number;
    /** Points of the longest dotted line in each plot, and in the plan. */
    dotted: Record<string, number>;
    /** Of the plan's last picture: ends of the parallel index's lines, and the first bearing line's ring, px. */
    laid: { lines: [number, number][][]; ring: number };
    /** The modules of the deck's sound. */
    sound: typeof chain & typeof alarm & typeof deck & typeof samples & typeof strikes & typeof voices;
  }
  interface CanvasRenderingContext2D {
    /** Of the path that is drawn, as tests count them. */
    points: number;
  }
}

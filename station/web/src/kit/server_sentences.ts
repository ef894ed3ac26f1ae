// Sentences of events that the server makes up where it calls them, and not of words.json, by the event's code: for the
// pages' other languages. {0} is a name or words of ours, {order} stands for what was spoken. The longer ones first.
// One that the server has changed stays English.

import { enumerations } from "../../../../words/words.json";

const ofOrders = enumerations.BridgeOrderState.oneOf.map(({ const: state, said }) => [
  `order.${state}`,
  [`order {0} ${state === "given" ? state : said}: {order}`],
]);

/** A hint that was searched for. */
const hints = ["", "port ", "starboard "].flatMap((side) => [
  `The ${side}wheel hard on now.`,
  `The ${side}wheel wide open now.`,
  `The ${side}wheel {0} % on now.`,
  `The ${side}speed lever at stop now.`,
  `The ${side}speed lever {0} % heave now.`,
  `The ${side}speed lever {0} % lower now.`,
  `The ${side}clutch in gear now.`,
  `The ${side}clutch out of gear now.`,
  `The ${side}stopper closed now.`,
  `The ${side}stopper off now.`,
]);
const noHint = [
  "Nothing is lost in the next minute if everything stays as it is.",
  "No single lever is known that would keep what is being lost.",
];

export const serverSentences: Readonly<Record<string, readonly string[]>> = {
  ...(Object.fromEntries(ofOrders) as Record<string, string[]>),
  "assessment.unanswered": ["the bridge asks again: if it hears nothing it gives up at {0} s, and the lesson ends"],
  "cable.shackle": [
    "{0} shackle on deck, heaving",
    "{0} shackles on deck, heaving",
    "{0} shackle in the pipe",
    "{0} shackles in the pipe",
  ],
  "cable.turns": ["{0} turns in the cable: links no longer lie fair"],
  "clutch.refused": [
    "clutch is loaded and does not come out",
    "clutch is broken",
    "clutch teeth are not in line: turn the motor over slowly",
    "clutch does not go in while the gypsy turns",
  ],
  "deck_work.begun": ["men begin: {0}"],
  "deck_work.endangered": ["the cable moves while men are at it: {0}"],
  "deck_work.waits": ["men wait: {0}"],
  "exercise.checkpoint": ["checkpoint taken by {name}"],
  "exercise.finished": ["exercise finished: {reason}"],
  "exercise.loaded": ["exercise loaded by {name}"],
  "exercise.paused": ["exercise holds for a question", "exercise paused by {name}"],
  "exercise.prediction": ["predictions on by {name}", "predictions off by {name}"],
  "exercise.reset": ["exercise reset by {name}"],
  "exercise.restored": ["exercise restored to {0} s, paused, by {name}"],
  "exercise.resumed": ["exercise goes on", "exercise resumed by {name}"],
  "exercise.started": ["exercise started by {name}"],
  "exercise.time_scale": ["time scale {0} by {name}"],
  "fault.active": ["{0} is active"],
  "fault.armed": ["{0} is armed"],
  "fault.cleared": ["{0} is cleared"],
  "hint.bridge": [
    "The engine stopped now.",
    "The engine {0} % ahead now.",
    "The engine {0} % astern now.",
    "The rudder {0} deg to starboard now.",
    "The rudder {0} deg to port now.",
    ...noHint,
  ],
  "hint.forecastle": [...hints, ...noHint],
  "levers.lost": [
    "{name} is not at the levers: nobody has the {0}; {1}",
    "{name} is no longer heard and nobody has the {0}: {1}",
    "nobody has moved the levers of the {0} yet: {1}",
  ],
  "levers.taken": [
    "{name} has the {0}, taken from {other}",
    "{name} has the {0}, handed back by {other}",
    "{name} has the {0}",
  ],
  "order.not_heard": ["no answer from the forecastle; ordered: {order}"],
  "report.bell": ["bell: {0} strokes", "bell: {0} stroke", "bell: rung rapidly"],
  "report.made": ["reported: {report}"],
  "report.not_heard": ["no answer from the bridge; reported: {report}"],
  "signals.anchor_ball": ["anchor ball hoisted", "anchor ball taken down"],
  "signals.anchor_lights": ["anchor lights switched on", "anchor lights switched off"],
  "stopper.refused": ["stopper bar is loaded and does not lift", "stopper cannot be closed on running chain"],
  "watch.circle": ["ship has left the anchor watch circle of {0} m"],
  "watch.dragging": ["by her position the ship drags: {0} m from the anchor's place"],
};

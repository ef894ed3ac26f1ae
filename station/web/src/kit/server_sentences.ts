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
  "Nothing that a lever keeps is lost in the next minute if everything stays as it is.",
  "No single lever is known that would keep what is being lost: {0}",
  "There was no time to find out what is being lost: ask again.",
];

/** What the model has counted of its steps, within other sentences; {1} lists how many of each kind. */
export const modelSteps = "of {0} steps of the cables {1}";
export const stepKinds: readonly string[] = [
  "implicit",
  "unsolved",
  "with friction of the step's start",
  "with contacts unsettled",
  "with contacts left out",
  "too long",
];

/** Why a lesson ended before it was done, where it is no event's code. */
export const endings: readonly string[] = [
  "ended before its lesson was done",
  'the bridge had no answer to "{order}"',
  'the bridge heard no more after "{order}"',
  'the bridge heard no "{report}" after "{order}"',
  "the bridge heard nothing",
  'the bridge was repeated wrongly: "{order}"',
  'the bridge was told what is not so when it asked "{order}"',
  "time is up",
];

export const serverSentences: Readonly<Record<string, readonly string[]>> = {
  ...(Object.fromEntries(ofOrders) as Record<string, string[]>),
  "anchor.fouled": ["anchor is foul of her own cable"],
  "assessment.finished": [
    "lesson {lesson} is over: {0} points, achieved",
    "lesson {lesson} is over: {0} points, not_yet",
    "lesson {lesson} is over: {0} points, not_shown",
  ],
  "assessment.misled": [
    "the bridge was told what is not so: if it hears nothing else it gives up at {time}, and the lesson ends",
  ],
  "assessment.unanswered": ["the bridge asks again: if it hears nothing it gives up at {time}, and the lesson ends"],
  "cable.parted": ["cable has parted {0} m from the anchor: anchor lost"],
  "cable.shackle": [
    "{0} shackle on deck, heaving",
    "{0} shackles on deck, heaving",
    "{0} shackle in the pipe",
    "{0} shackles in the pipe",
  ],
  "cable.turns": ["{0} turns in the cable: links no longer lie fair"],
  "classroom.created": ["exercise {id} ({file}) created by {name}"],
  "classroom.gave_way": ["exercise {id} closed by {name}: server {other} has one of this name already"],
  "classroom.reading": ["exercise {id}: the order of {name} takes its time, an exercise is being read"],
  "classroom.removed": ["exercise {id} removed by {name}"],
  "clutch.refused": [
    "clutch is loaded and does not come out",
    "clutch is broken",
    "clutch teeth are not in line: turn the motor over slowly",
    "clutch does not go in while the gypsy turns",
  ],
  "deck_work.begun": ["men begin: {0}"],
  "deck_work.endangered": ["the cable moves while men are at it: {0}"],
  "deck_work.waits": ["men wait: {0}"],
  "environment.changed": ["weather is being changed by the instructor", "weather changed by the instructor"],
  "exercise.bookmark": ["bookmark"],
  "exercise.checkpoint": ["checkpoint taken by {name}"],
  "exercise.finished": ["exercise finished: by {name}", "exercise finished: the set duration was run"],
  "exercise.held": ["exercise holds for a question"],
  "exercise.kept": ["kept on disk again"],
  "exercise.loaded": ["exercise loaded by {name}"],
  "exercise.not_kept": ["not kept on disk: {why}"],
  "exercise.not_taken_up": ["begins anew after the server was lost: {why}"],
  "exercise.paused": ["exercise paused by {name}"],
  "exercise.prediction": ["predictions on by {name}", "predictions off by {name}"],
  "exercise.reading": ['exercise "{file}" is being read for {name}'],
  "exercise.reset": ["exercise reset by {name}"],
  "exercise.restored": [
    "exercise restored to {time}, paused, from a checkpoint by {name}",
    "exercise restored to {time}, paused, from {from} by {name}",
    "exercise restored to {time}, paused, by {name}",
  ],
  "exercise.resumed": ["exercise goes on", "exercise resumed by {name}"],
  "exercise.started": ["exercise started by {name}"],
  "exercise.stopped_by_fault": ["exercise stopped: {why}"],
  "exercise.taken_up": ["taken up again at {time} after the server was lost, {0}"],
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
  "lesson.over": [
    "the lesson is over: an order was repeated back wrongly to the last",
    "the lesson is over: it has run its course",
    "the lesson is over: it was ended",
    "the lesson is over: its time is up",
    "the lesson is over: the bridge had no answer",
    "the lesson is over: the bridge was told what is not so",
    "the lesson is over: what has happened ends it",
  ],
  "levers.lost": [
    "its last hand is not at the levers: nobody has the {0}; {1}",
    "{name} is not at the levers: nobody has the {0}; {1}",
    "{name} is no longer heard and nobody has the {0}: {1}",
    "nobody has moved the levers of the {0} yet: {1}",
  ],
  "levers.taken": [
    "{name} has the {0}, taken from {other}",
    "{name} has the {0}, handed back by {other}",
    "{name} has the {0}",
  ],
  "model.in_doubt": ["in the last 10 s {steps}"],
  "model.steps": ["in the last minute {steps}"],
  "order.not_heard": ["no answer from the forecastle; ordered: {order}"],
  "question.answered": ["{0} answers ({id}): {answer}"],
  "question.asked": ["{0} is asked ({id}): {question}"],
  "question.passed_over": ["{id}: {name} goes on without an answer"],
  "report.bell": ["bell: {0} strokes", "bell: {0} stroke", "bell: rung rapidly"],
  "report.made": ["reported: {report}"],
  "report.not_heard": ["no answer from the bridge; reported: {report}"],
  "signals.anchor_ball": ["anchor ball hoisted", "anchor ball taken down"],
  "signals.anchor_lights": ["anchor lights switched on", "anchor lights switched off"],
  "stopper.refused": ["stopper bar is loaded and does not lift", "stopper cannot be closed on running chain"],
  "watch.circle": ["ship has left the anchor watch circle of {0} m"],
  "watch.dragging": ["by her position the ship drags: {0} m from the anchor's place"],
};

// What the door says to people in sentences of its own, for the pages' other languages; what only a program that speaks
// to it wrongly is told is not here. {0} is a figure or words of ours, a place with a name what somebody is called.

import { translatedAs } from "../kit/language";

const refusals = [
  "{id} is a class already: {free} is free",
  "{id} is a class that is over, whose results are kept: {free} is free",
  "{name} has a seat in another browser; if that was you, ask the instructor to free it",
  "{name} has a seat in this class already",
  "{name} is not on the list of this class: ask the instructor",
  "{name} sits here",
  "{0} classes at a time: end one",
  "{0} kiosks are kept: remove one",
  "{0} lessons that learning systems have started are under way: try again later",
  "an instructor has that name",
  "an instructor has that name: choose another",
  "as many lessons are under way as may be: try again later",
  "crew: in this lesson the bridge orders and the forecastle obeys: 2 or 3",
  "every seat of this class is taken",
  "exercise {id} is not there yet, and enough waits for it",
  "it holds for a question, and goes on once that is answered",
  "lesson: {lesson} is for two, and a learning system starts one learner alone",
  "lesson: {lesson}: there is no such lesson here",
  "many are at the door: try again",
  "name or password is wrong",
  "name: 1 to 24 letters, digits and dashes are allowed",
  "name: 1 to 32 bytes of text are allowed, but not server or door",
  "name: none that begins with replay",
  "names: an instructor is called {name}",
  "names: {name} stands there twice",
  "names: {0} are more than the {1} seats",
  "no class has such an attempt in the history",
  "no class has this code today",
  "no learning system may start lessons here",
  "nobody of that name is in this class",
  "nobody sits in this class yet: an exercise is started once somebody does",
  "not all exercises stand at their moment yet: wait",
  "not for {0}",
  "one owner has to remain",
  "password: {0} to {1} characters are allowed",
  "somebody was faster",
  "there are as many people as are kept",
  "there are exercises of that name still: choose another, or wait",
  "there is a class of that name",
  "there is no kiosk of that name",
  "there is no such class",
  "this address was opened before, or was taken back: ask the owner for another",
  "this class has a list of names: take a seat by its code",
  "this class has no such seat",
  "this device is no kiosk any more: ask the owner for an address",
  "this is for instructors: log in",
  "this launch is under way already",
  "this launch was used before: start the lesson in the learning system again",
  "this link is not good any more: log in, or start the door anew for another",
  "too many were wrong: try again in {0} s",
];

/** Why a page was sent away from its seat. */
const partings = [
  "log in again",
  "logged out",
  "the class is over: your instructor has your marks and the debriefing",
  "the lesson is over",
  "this browser has another seat now",
  "this device is no kiosk any more",
  "this seat was freed by the instructor",
  "this seat was moved",
];

/** What is wrong with an exercise of a class. */
const troubles = ["it is not recorded: {why}", "server {name} was asked for it and has not made it: its log says why"];

/** What somebody is to practise next, and why: the history's. */
const reasons = [
  "another had the seat before or after; now alone, from beginning to end",
  "done for practice; now as a test, without hints",
  "it was not achieved",
  "not done yet",
  "tried before, and not achieved in all of it",
];

/** Why it is not done again from a moment. */
const noMoments = [
  "its recording cannot be read",
  "its recording is here no more",
  "what is missing went wrong at no moment",
];

export const doorSentences: readonly string[] = [...refusals, ...partings, ...troubles, ...reasons, ...noMoments];

/** In the person's language; as it came where the catalogue has no such sentence. */
export function doorSaid(text: string): string {
  for (const sentence of doorSentences) {
    const found = translatedAs(sentence, text);
    if (found !== text) return found;
  }
  return text;
}

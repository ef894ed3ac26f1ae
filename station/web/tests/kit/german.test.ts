// What server and door say, as somebody reads it whose browser speaks German.

import assert from "node:assert/strict";
import { test } from "node:test";

const give = (name: string, value: object): void =>
  void Object.defineProperty(globalThis, name, { value, configurable: true });
give("document", { documentElement: {} });
give("navigator", { languages: ["de-DE"] });
const { alertWords, allSaid, endingSaid, eventText, saidOf } = await import("../../src/kit/words");
const { t } = await import("../../src/kit/language");
const { AnchorPhase, DeckWork } = await import("../../src/wire/generated");
const { doorSaid } = await import("../../src/door/door_sentences");

void test("sentences that the server makes up are read in German", () => {
  const german: [code: string, text: string, said: string][] = [
    ["lesson.over", "the lesson is over: its time is up", "die Lektion ist beendet: die Zeit ist um"],
    [
      "levers.lost",
      "its last hand is not at the levers: nobody has the helm; the helm's levers stay as they are",
      "der vorige Bediener ist nicht an den Hebeln; unbesetzt: Ruder und Maschine; " +
        "die Hebel der Brücke bleiben, wie sie sind",
    ],
    [
      "assessment.finished",
      "lesson L04 is over: 81.5 points, not_yet",
      "Lektion L04 ist beendet: 81,5 Punkte, noch nicht bestanden",
    ],
    [
      "model.in_doubt",
      "in the last 10 s of 3000 steps of the cables 2 unsolved, 1 too long",
      "in den letzten 10 s von 3000 Rechenschritten der Ketten 2 ungelöst, 1 zu lang",
    ],
    ["question.asked", "bridge is asked (lead): How does she lead?", "Brücke wird gefragt (lead): How does she lead?"],
    ["classroom.removed", "exercise anna removed by desk-1", "Übung anna entfernt von desk-1"],
    [
      "assessment.unanswered",
      "the bridge asks again: if it hears nothing it gives up at 6:18, and the lesson ends",
      "die Brücke fragt noch einmal: hört sie nichts, gibt sie bei 6:18 auf, und die Lektion endet",
    ],
    [
      "assessment.misled",
      "the bridge was told what is not so: if it hears nothing else it gives up at 6:18, and the lesson ends",
      "der Brücke wurde Falsches gemeldet: hört sie nichts anderes, gibt sie bei 6:18 auf, und die Lektion endet",
    ],
    [
      "exercise.restored",
      "exercise restored to 1:02, paused, from monday at 0:00 by desk-1",
      "Übung zurückgesetzt auf 1:02, angehalten, nach monday at 0:00, von desk-1",
    ],
    ["exercise.finished", "exercise finished: by desk-1", "Übung beendet von desk-1"],
  ];
  for (const [code, text, said] of german) assert.equal(eventText({ code, text }), said);
});

void test("an alert names whose the levers were in German, unless it is somebody's name", () => {
  const of = (who: string): string =>
    alertWords({
      code: "levers.unattended",
      text: "Nobody has the port windlass",
      explanation:
        `${who} had it and is not at the levers; speed lever at zero; brake, clutch and stopper as they were. ` +
        "Whoever moves the levers next has them.",
    }).explanation;
  const rest =
    "(ist nicht an den Hebeln); Fahrhebel auf Null; Bremse, Kupplung und Stopper unverändert. " +
    "Wer die Hebel als Nächster bewegt, hat sie.";
  assert.equal(of("its last hand"), `Zuletzt der vorige Bediener ${rest}`);
  assert.equal(of("ben"), `Zuletzt ben ${rest}`);
});

// MSC.302(87): caution, warning, alarm, emergency alarm.
void test("no priority of an alert has the name of a lesson's hint", () => {
  const priorities = allSaid("AlertPriority");
  assert.deepEqual(priorities, ["Vorsicht", "Warnung", "Alarm", "Notalarm"]);
  assert.ok(!priorities.includes(t("Hint")) && t("cautions") !== t("Hints"));
});

void test("words of the trade are not those that mean something else ashore, or of a ship", () => {
  const landed = { code: "anchor.on_bottom", text: "anchor on the bottom, 27.5 m of cable out" };
  assert.equal(eventText(landed), "Anker am Grund, 27,5 m Kette gesteckt"); // a ship that is aground is "auf Grund"
  assert.equal(saidOf("AnchorPhase", AnchorPhase.ANCHOR_ON_BOTTOM), "am Grund");
  assert.equal(t("SPRUNG"), "SPRANG AUF"); // "gesprungen" is cracked
  assert.equal(saidOf("DeckWork", DeckWork.DECK_WORK_SLIP), "Sliphaken ausschlagen"); // "der Slip" is clothing
  assert.equal(t("CCTV on"), "Kameras an");
});

void test("why a lesson ended, what the door refuses and what is to be practised are read in German", () => {
  assert.equal(endingSaid("time is up"), "die Zeit ist um");
  assert.equal(endingSaid("cable.lost"), "die ganze Kette ist ausgerauscht: Anker und Kette verloren");
  assert.equal(endingSaid('the bridge had no answer to "let go"'), "die Brücke bekam keine Antwort auf „let go“");
  assert.equal(
    endingSaid('the bridge heard no "ready" after "put port windlass in gear"'),
    "die Brücke hörte kein „ready“ nach „put port windlass in gear“", // as button and order are called
  );
  assert.equal(doorSaid("no class has this code today"), "diesen Code hat heute keine Klasse");
  assert.equal(doorSaid("ben sits here"), "hier sitzt ben");
  assert.equal(doorSaid("not done yet"), "noch nicht gemacht");
  assert.equal(doorSaid("something else"), "something else");
});

// A lesson that a learning system has started (cmi5): its address brings the learner in once; from then on this page
// says how it stands, and leads back when the learning system is told what came of it.

import { h, setText } from "../kit/dom";
import { chooseLanguage, language, languages, t } from "../kit/language";
import { pointsFigure } from "../kit/points_said";
import { type Launch, type Me, act, ask } from "./ask";
import { frame } from "./frame";

const kAgain = 1000; // ms
const kLeadsBack = 20; // s in which what came of it can be read

/** What the learner prefers, unless this browser reads it already: the first of ours in "de-DE,en". */
function preferred(told = ""): void {
  const first = told
    .split(",")
    .map((tag) => tag.trim().slice(0, 2).toLowerCase())
    .find((tag) => Object.hasOwn(languages, tag)) as typeof language | undefined;
  if (first && first !== language) chooseLanguage(first);
}

function verdictSaid({ verdict, points, counts }: Launch): string {
  const said = pointsFigure(points ?? 0);
  if (verdict === "passed") return t("Passed, with {points} of 100 points", { points: said });
  if (verdict === "failed") return t("Not passed, with {points} of 100 points", { points: said });
  return counts
    ? t("The lesson was ended before it was over: it counts neither as passed nor as failed")
    : t("You have looked around: nothing of it counts");
}

export async function makeLaunch(): Promise<void> {
  const root = frame(t("A lesson of your course"));
  const head = h("h2", {}, t("Asks the door …"));
  const said = h("p", { role: "status" });
  const ways = h("p", { class: "ways" });
  root.append(h("div", { class: "narrow text" }, h("section", { class: "panel waiting" }, head, said), ways));

  /** What can be done now; made anew only where it differs. */
  let offered = "";
  const offer = (what: string, ...nodes: Node[]): void => {
    if (offered !== what) ways.replaceChildren(...nodes);
    offered = what;
  };
  let leads: ReturnType<typeof setTimeout> | undefined;
  const show = ({ launch }: Me): boolean => {
    if (!launch) {
      location.assign("/");
      return false;
    }
    if (launch.state === "under_way") {
      setText(head, t("The lesson {lesson} is ready for {name}", { lesson: launch.lesson, name: launch.name }));
      setText(
        said,
        launch.counts
          ? t("It begins when you enter the ship, is recorded, and what comes of it goes to your course.")
          : t("To look around, with hints: nothing of it goes to your course."),
      );
      offer(
        "begin",
        h("a", { class: "button", href: "/" }, t("Enter the ship")),
        h("button", { class: "plain", onclick: () => void act("finish", {}) }, t("Finish")),
      );
    } else if (launch.state === "marking") {
      setText(head, t("The lesson is over"));
      setText(said, t("Its recording is closed and read …"));
      offer("marking");
    } else {
      setText(head, verdictSaid(launch));
      const { back } = launch;
      setText(
        said,
        launch.waits ? t("Your course is told as soon as it is heard.") : t("Your course knows of it. You may leave."),
      );
      if (!back) return launch.waits;
      offer("back", h("a", { class: "button", href: back }, t("Back to the course")));
      leads ??= setTimeout(() => location.assign(back), kLeadsBack * 1000);
    }
    return true;
  };

  const asked = new URLSearchParams(location.search);
  const lesson = decodeURIComponent(location.pathname.replace(/^\/cmi5\/?/, ""));
  const finish = location.hash === "#finish";
  history.replaceState(null, "", "/cmi5"); // the launch is good once, and nobody's who looks over a shoulder
  try {
    if (lesson) {
      const me = await act<Me>("launch", { lesson, ...Object.fromEntries(asked) });
      preferred(me.launch?.languages);
    } else if (finish) await act("finish", {});
  } catch (refused) {
    setText(head, t("The lesson cannot be started"));
    setText(said, (refused as Error).message);
    return;
  }
  for (let goesOn = true; goesOn;) {
    try {
      goesOn = show(await ask<Me>("me"));
    } catch {
      setText(said, t("The door is not heard: tries again"));
    }
    await new Promise((done) => setTimeout(done, kAgain));
  }
}

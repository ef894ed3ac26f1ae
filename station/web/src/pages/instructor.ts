// The instructor's desk: everything seen, everything reached; a replay's too. An assessor or observer has it as well,
// with what such a seat may give.

import "uplot/dist/uPlot.min.css";
import "./instructor.css";

import { makeDesk } from "../desk/desk_page";
import { openExercisePage } from "../kit/page";
import { t } from "../kit/language";
import type { Seat } from "../wire/connection";

const titleOf = (seat: Seat): string =>
  seat === "assessor" ? t("Assessor") : seat === "observer" ? t("Observer") : t("Instructor");

const page = openExercisePage(t("Instructor"), "ShipState");
page.link.onState((state) => {
  if (state === "open" && page.link.hello) page.topBar.name(titleOf(page.link.hello.seat));
});
makeDesk(page);
Object.assign(window, { windlass: { link: page.link } }); // for tests

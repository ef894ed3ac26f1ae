// The instructor's desk: everything seen, everything reached; a replay's too.

import "uplot/dist/uPlot.min.css";
import "./instructor.css";

import { makeDesk } from "../desk/desk_page";
import { openExercisePage } from "../kit/page";
import { t } from "../kit/language";

const page = openExercisePage(t("Instructor"), "ShipState");
makeDesk(page);
Object.assign(window, { windlass: { link: page.link } }); // for tests

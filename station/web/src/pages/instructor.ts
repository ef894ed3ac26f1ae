// The instructor's desk: everything seen, everything reached; a replay's too.

import "uplot/dist/uPlot.min.css";
import "./instructor.css";

import { makeDesk } from "../desk/desk_page";
import { openExercisePage } from "../kit/page";
import { t } from "../kit/language";

makeDesk(openExercisePage(t("Instructor"), "ShipState"));

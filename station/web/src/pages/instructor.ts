// The instructor's desk: everything seen, everything reached; a replay's too.

import "uplot/dist/uPlot.min.css";
import "./instructor.css";

import { makeDesk } from "../desk/desk_page";
import { openPage } from "../kit/page";

makeDesk(
  openPage("Instructor", [
    "ExerciseStatus",
    "ExerciseTruth",
    "EnvironmentState",
    "ShipState",
    "AnchorState",
    "ChainState",
    "WindlassLoad",
    "Daylight",
    "LightsAndShapes",
    "SeaState",
    "SceneDescription",
    "SeabedDescription",
    "Event",
    "Alert",
    "ServerAlert",
    "BridgeOrder",
    "Report",
    "WindlassCommand",
    "InstructorWindlassCommand",
    "HelmCommand",
    "InstructorHelmCommand",
    "ReplayStatus",
  ]),
);

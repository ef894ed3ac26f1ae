// The instructor's desk: everything seen, everything reached; a replay's too.

import "./instructor.css";

import { openPage } from "../kit/page";

openPage("Instructor", ["ExerciseStatus", "ExerciseTruth", "Alert", "ServerAlert"]);

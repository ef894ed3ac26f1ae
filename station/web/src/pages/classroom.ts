// All exercises at a glance.

import "./classroom.css";

import { openPage } from "../kit/page";

openPage("Classroom", ["ClassroomStatus"]);

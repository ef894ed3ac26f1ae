// All exercises at a glance.

import "./classroom.css";

import { makeClassroom } from "../classroom/classroom_page";
import { openPage } from "../kit/page";

makeClassroom(openPage("Classroom"));

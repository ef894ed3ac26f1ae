// All exercises at a glance.

import "./classroom.css";

import { makeClassroom } from "../classroom/classroom_page";
import { openPage } from "../kit/page";
import { t } from "../kit/language";

makeClassroom(openPage(t("Classroom")));

// Exercise files: lessons and where they happen, as forms.

import "./lessons.css";

import { openPage } from "../kit/page";
import { makeEditor } from "../lessons/editor";
import { t } from "../kit/language";

makeEditor(openPage(t("Lessons")));

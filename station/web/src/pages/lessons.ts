// Exercise files: lessons and where they happen, as forms.

import "./lessons.css";

import { openPage } from "../kit/page";
import { makeEditor } from "../lessons/editor";

makeEditor(openPage("Lessons"));

// The page of a class: its code, and who sits where.

import "./door.css";

import { makeClass } from "../door/class_page";

await makeClass();

// The page by which instructors come in.

import "./door.css";

import { makeLogin } from "../door/login";

makeLogin();

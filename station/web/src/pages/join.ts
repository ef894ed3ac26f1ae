// The page by which trainees come in.

import "./door.css";

import { makeJoin } from "../door/join";

makeJoin();

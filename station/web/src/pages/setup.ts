// The page on which the first owner is set up.

import "./door.css";

import { makeSetup } from "../door/login";

makeSetup();

// The page at which a learning system starts a lesson, and at which the learner hears what came of it.

import "./door.css";

import { makeLaunch } from "../door/launch";

await makeLaunch();

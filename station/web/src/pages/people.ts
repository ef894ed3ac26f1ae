// The page of those who may log in.

import "./door.css";

import { makePeople } from "../door/people";

await makePeople();

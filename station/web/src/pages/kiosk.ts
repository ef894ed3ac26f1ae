// The page of a device that stands at one seat, while nobody needs it.

import "./door.css";

import { makeKiosk } from "../door/kiosk";

await makeKiosk();

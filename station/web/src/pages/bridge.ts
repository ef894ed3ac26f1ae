// The bridge's page: ship in hand, orders to the forecastle.

import "./bridge.css";

import { openPage } from "../kit/page";

openPage("Bridge", ["ExerciseStatus", "BridgeView", "SeatEvent", "Alert"]);

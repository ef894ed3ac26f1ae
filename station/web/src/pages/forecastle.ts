// The forecastle's page: the windlass in hand.

import "./forecastle.css";

import { openPage } from "../kit/page";

openPage("Forecastle", ["ExerciseStatus", "ForecastleView", "SeatEvent", "Alert"]);

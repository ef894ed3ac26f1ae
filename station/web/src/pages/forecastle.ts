// The forecastle's page: the windlass in hand.

import "./forecastle.css";

import { openForecastle } from "../forecastle/page";

openForecastle();

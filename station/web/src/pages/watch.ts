// The anchor watch's page: the bridge, with circle and book beside the plan.

import "./bridge.css";

import { openBridge } from "../bridge/bridge";
import { t } from "../kit/language";

openBridge(t("Anchor watch"), "watch");

// The bridge's page: ship in hand, orders to the forecastle.

import "./bridge.css";

import { openBridge } from "../bridge/bridge";
import { t } from "../kit/language";

openBridge(t("Bridge"), "orders");

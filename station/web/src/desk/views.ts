// The pictures of the desk: the scene from anywhere, and the plan.

import { h } from "../kit/dom";
import type { Desk } from "./desk";
import { PlanFeed } from "./plan_feed";

export class Views {
  readonly element: HTMLElement;

  constructor(desk: Desk, _still: boolean) {
    const plan = h("div", { class: "view plan-view" });
    this.element = h("div", { class: "views" }, plan);
    new PlanFeed(plan, desk.link, desk.events);
  }
}

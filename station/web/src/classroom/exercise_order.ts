// An order to an exercise that this page has no link with: a link for as long as it takes.

import { pageToken } from "../kit/page";
import { Connection, type OrderSample, Refused } from "../wire/connection";
import type { TopicName } from "../wire/generated";
import { t } from "../kit/language";

const kWait = 5000; // ms, for the exercise to be joined

/** Resolves when the order is on its way; rejects with Refused. */
export async function orderIn(exercise: string, topic: TopicName, sample: OrderSample): Promise<void> {
  const link = new Connection(pageToken(), exercise);
  try {
    await new Promise<void>((opened, failed) => {
      const timer = setTimeout(() => failed(new Refused(t("{exercise} is not reached", { exercise }))), kWait);
      link.onState((state) => {
        if (state !== "open") return;
        clearTimeout(timer);
        opened();
      });
    });
    await link.order(topic, sample);
  } finally {
    link.close();
  }
}

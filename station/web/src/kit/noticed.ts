// On which topic a page hears what is noticed at its seat.

export const noticedAt = { forecastle: "ForecastleEvent", bridge: "BridgeEvent" } as const;

// Where the eye stands on the bridge: for the window, and for bearings that are laid on the plan from there.

/** m forward of midships, just before the windows of the house that the scene's deck.ts builds. */
export const bridgeEye = (lengthOverall: number): number => -0.445 * lengthOverall + 11;

// How often a picture is drawn where the processor draws it: levers, gauges and the exercise's server need it, too.

const kShare = 0.6; // of the time, that the one picture of a page may take
const kWaitMax = 1000; // ms between two pictures, however slow the machine
const kTookMax = 500; // ms that are told of one: the page may have been hidden meanwhile
const kGivenUp = 5000; // ms after which a picture that is not told to be finished is taken to be: a lost context

/** Leaves time between pictures, by the share of it that they may take to draw. Times are ms of performance.now(). */
export class Pace {
  /** ms that the last picture took, to the next look; half a second at most. */
  took = 0;
  private begun: { at: number; fence: WebGLSync | null } | undefined;
  private next = 0;

  /** share: of the time, that drawing may take. */
  constructor(
    private readonly gl: WebGL2RenderingContext,
    private readonly share = kShare,
  ) {}

  /** Whether another picture may be drawn now. To be asked once a frame. */
  due(now: number): boolean {
    if (this.begun && this.isFinished(this.begun, now)) {
      const took = now - this.begun.at;
      this.took = Math.min(took, kTookMax);
      this.next = now + Math.min(took * (1 / this.share - 1), kWaitMax);
      this.gl.deleteSync(this.begun.fence);
      this.begun = undefined;
    }
    return !this.begun && now >= this.next;
  }

  /** One was begun at that time, and its commands are all given. */
  given(at: number): void {
    this.begun = { at, fence: this.gl.fenceSync(this.gl.SYNC_GPU_COMMANDS_COMPLETE, 0) };
    this.gl.flush();
  }

  private isFinished({ at, fence }: { at: number; fence: WebGLSync | null }, now: number): boolean {
    const { gl } = this;
    return !fence || now - at > kGivenUp || gl.getSyncParameter(fence, gl.SYNC_STATUS) === gl.SIGNALED;
  }
}

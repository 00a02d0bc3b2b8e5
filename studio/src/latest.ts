// Work of which only the latest matters.

/** One piece at a time; while it runs, of those that come the last one is kept. abandon: says that nobody waits any more
    for the one that runs. */
export class Latest {
  private next: (() => Promise<void>) | null = null;
  private isRunning = false;
  constructor(private abandon: () => void = () => undefined) {}

  /** Whether a next one has come while one runs. */
  get isWaiting(): boolean {
    return this.next !== null;
  }

  /** isAsked: what it waits for is asked already, and has taken the place of what was asked before. */
  run(work: () => Promise<void>, isAsked = false): void {
    this.next = work;
    if (!this.isRunning) void this.loop();
    else if (!isAsked) this.abandon();
  }
  /** Nothing is wanted any more. */
  stop(): void {
    this.next = null;
    if (this.isRunning) this.abandon();
  }

  private async loop(): Promise<void> {
    this.isRunning = true;
    try {
      while (this.next) {
        const work = this.next;
        this.next = null;
        try {
          await work();
        } catch (error) {
          reportError(error); // the next one comes all the same
        }
      }
    } finally {
      this.isRunning = false;
    }
  }
}

/** A function that is called when nothing has asked for it for a while [ms]. */
export function debounced<A extends unknown[]>(pause: number, work: (...args: A) => void): (...args: A) => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  return (...args) => {
    clearTimeout(timer);
    timer = setTimeout(() => work(...args), pause);
  };
}

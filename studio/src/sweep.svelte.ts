// A sweep: what varies, what is looked at, and what came of it. Once it has been asked for it follows the text.
import { debounced } from "./latest";
import * as server from "./server";
import { studio } from "./state.svelte";
import { quantityOf, sweepRange } from "./text";
import type { Parameter, SweepAnswer, SweepRequest } from "./wire";

export const TOPIC = "sweep";
/** How a value of a motion is asked for, before the name of the series. */
export const RECORDS = ["maximum of", "minimum of", "final"] as const;

class Sweeping {
  private chosen = $state("");
  private what = $state("");
  private ofSeries = $state("");
  low = $state("");
  high = $state("");
  n = $state(41);
  private hasRange = ""; // the name and the file that the range is for

  answer = $state.raw<SweepAnswer | null>(null);
  message = $state("");
  hasTable = $state(false);
  isWorking = $state(false);
  private isFollowing = $state(false);
  private sought = $state(""); // what was asked last
  private answered = $state(""); // what is shown
  private nAsked = 0;

  // -- what is asked
  get parameter(): Parameter | undefined {
    return studio.parameters.find((each) => each.name === this.chosen) ?? studio.parameters[0];
  }
  get questions() {
    return studio.model?.questions ?? [];
  }
  get series(): string[] {
    return studio.curves?.recordable ?? [];
  }
  /** One of `RECORDS`, or the id of a question behind a colon. */
  get looked(): string {
    const known = [...this.questions.map((each) => `:${each.id}`), ...(this.series.length ? RECORDS : [])];
    return known.includes(this.what) ? this.what : (known[0] ?? "");
  }
  get recorded(): string {
    return this.series.includes(this.ofSeries) ? this.ofSeries : (this.series[0] ?? "");
  }
  record(name: string): void {
    this.ofSeries = name;
  }
  choose(name: string): void {
    this.chosen = name;
    this.range();
  }
  look(what: string): void {
    this.what = what;
  }
  /** Another name, or file, has another range; what is typed stays. */
  range(): void {
    const parameter = this.parameter, now = `${studio.folder.file} ${parameter?.name}`;
    if (!parameter || now === this.hasRange) return;
    this.hasRange = now;
    [this.low, this.high] = sweepRange(parameter.text, parameter.is_positive);
  }
  private get request(): Omit<SweepRequest, "text"> | null {
    const name = this.parameter?.name, looked = this.looked;
    if (!name || !this.low.trim() || !this.high.trim() || !looked || !(this.n >= 2 && this.n <= 1001)) return null;
    const of = looked.startsWith(":") ? { find: looked.slice(1) } : { record: `${looked} ${this.recorded}`, until: studio.until };
    return { language: studio.language, name, low: this.low, high: this.high, n: Math.round(this.n), ...of };
  }
  get wanted(): string {
    return JSON.stringify([studio.folder.file, this.request, studio.modelText, studio.nReturns]);
  }
  get canAsk(): boolean {
    return this.request !== null && studio.model !== null;
  }

  // -- what came of it
  /** Of another text, or of other choices. */
  get isBehind(): boolean {
    return this.answer !== null && (this.answered !== this.wanted || !studio.isCurrent || studio.read?.is_model === false);
  }
  get isDue(): boolean {
    return this.isFollowing && this.answer !== null && this.canAsk && studio.isAwaited && (this.sought !== this.wanted || !studio.isCurrent);
  }
  /** Where the file has the parameter, in the unit of what is shown. */
  get own(): number | null {
    const answer = this.answer, parameter = studio.parameters.find((each) => each.name === answer?.name);
    const quantity = parameter ? quantityOf(parameter.text) : null;
    return quantity && (quantity.rest.trim() || "1") === answer?.unit ? quantity.value : null;
  }

  begin(): void {
    this.isFollowing = true;
    this.sought = "";
    this.find();
  }
  cancel(): void {
    this.isFollowing = false;
    void server.cancel(TOPIC);
  }
  /** Nobody looks at it any more; what is there stays for the next time. */
  leave(): void {
    if (this.isWorking) void server.leave(TOPIC);
    [this.isWorking, this.sought] = [false, this.answered];
    this.nAsked += 1;
  }
  follow = debounced(350, () => {
    if (this.isFollowing) this.find();
  });
  private find(): void {
    const request = this.request, now = this.wanted, mine = this.nAsked + 1;
    if (!request || !studio.modelText || now === this.sought) return;
    [this.nAsked, this.sought, this.isWorking, this.message] = [mine, now, true, ""];
    void studio.asked("sweep", { ...request, text: studio.modelText }, TOPIC).then((told) => {
      if (mine !== this.nAsked) return;
      this.isWorking = false;
      if (told?.answer) [this.answer, this.answered] = [told.answer, now];
      else if (told && told.status !== "replaced") {
        this.message = studio.reason(told);
        if (told.status !== "refused") this.isFollowing = false; // what took too long is not begun by itself again
      }
    });
  }
  /** Of another file. */
  forget(): void {
    [this.answer, this.message, this.isFollowing, this.sought, this.answered] = [null, "", false, "", ""];
  }
}

export const sweeping = new Sweeping();

// The state of the page. The text is the only truth: everything else here follows from it, or is a matter of view.
import { kept } from "./kept";
import { Latest, debounced } from "./latest";
import type { Lit } from "./meanings";
import { Folder } from "./folder.svelte";
import { FEWER, Hand } from "./hand.svelte";
import { Marks } from "./marks.svelte";
import { notebook } from "./notebook";
import * as server from "./server";
import type { Told } from "./server";
import { type Change, changeBetween, local, printed, unitPrinted, wordsPrinted } from "./text";
import { ANGLES, LENGTHS, SI, type Units, linesIn, unitIn } from "./units";
import type { Answers, CurvesAnswer, Element, Kind, MotionAnswer, OverlaysRequest, Parameter, ReadAnswer, Requests, StudyAnswer } from "./wire";
import { WORDS, type Word, keysIn } from "./words";

export type Language = "en" | "de";
export type Theme = "light" | "dark";
export type Panel = "ask" | "derivation" | "free" | "mobility" | "conserved" | "more" | "properties" | "sweep" | "export";
export type Pane = "model" | "scene" | "results";

/** What the editor can do for the rest of the page. */
export interface Writer {
  change(changes: Change[], userEvent: string): void;
  load(text: string): void;
  /** The text with all that can be undone, and the same again. */
  kept(): unknown;
  restore(state: unknown): void;
  select(from: number, to: number): void;
  undo(): void;
  redo(): void;
  focus(): void;
}

/** Of the width that the outer panes have, unless somebody chooses. */
export const SHARES = { model: 24, results: 32 };
/** How long a slider stays where it is before all else follows [ms]: longer than a hand that moves it slowly pauses. */
const AT_REST = 200;
/** How often a motion follows while a slider moves the picture of its start, and how often curves follow motions that give
    way to the next [ms]: they are asked for in between, so that pictures stay quick. */
const WHOLE_EVERY = 150, CURVES_EVERY = 150;
const NARROWEST = 12, LEAST_SCENE = 20;
const prefersDark = matchMedia("(prefers-color-scheme: dark)");

export class Studio {
  // -- the text, and what it says
  text = $state("");
  read = $state.raw<ReadAnswer | null>(null);
  readText = $state("");
  /** The text that the reader gave no answer to. */
  unread = $state<string | null>(null);
  model = $state.raw<ReadAnswer | null>(null);
  modelText = $state("");
  parameters = $state.raw<Parameter[]>([]);
  kinds = $state.raw<Kind[]>([]);
  canUndo = $state(false);
  canRedo = $state(false);

  // -- what follows from it
  motion = $state.raw<MotionAnswer | null>(null);
  /** Of that motion, or of the one before for as long as they are on their way. */
  curves = $state.raw<CurvesAnswer | null>(null);
  /** Where the bodies of that motion would start now, until the motion from there has come. */
  begun = $state.raw<number[] | null>(null);
  motionMessage = $state("");
  motionText = $state("");
  count = $state.raw<StudyAnswer | null>(null);
  private countText = $state("");
  /** Where something changes along the sliders. */
  readonly marks = new Marks(this);
  isStale = $state(false);
  failure = $state("");
  /** Whether the server answers; how often it has come back. */
  isLost = $state(false);
  nReturns = $state(0);

  // -- the view
  language = $state<Language>("en");
  theme = $state<Theme>("light");
  panel = $state<Panel>("ask");
  pane = $state<Pane>("scene");
  shares = $state.raw(SHARES);
  units = $state.raw<Units>(SI);
  selected = $state<string | null>(null);
  /** Whether what is wrong with the text is listed above it. */
  hasProblems = $state(false);
  time = $state(0);
  until = $state(3);
  isMoving = false; // by hand: what is shown is on its way
  private isSliding = false; // the text is being changed by a slider
  dialog = $state<"" | "add" | "commands" | "gallery" | "help" | "save" | "changed" | "share" | "units">("");
  /** The kind that the next dialog begins with. */
  adding: Kind | null = null;
  derived = $state<string | null>(null);
  /** The question that is being typed, and the one that is answered. */
  question = $state("");
  asking = $state<string | null>(null);
  readonly hand = new Hand(this);
  /** What a symbol speaks of that is pointed at, or the body. */
  lit = $state.raw<Lit | null>(null);
  /** What is drawn over the motion. */
  shows = $state<OverlaysRequest["show"]>([]);
  /** The bodies that are cut free: each for itself, so that action and reaction are both to be seen, or as one. */
  freed = $state<string[]>([]);
  isApart = $state(true);
  /** Where the sliders of a shared page stand. */
  places = $state.raw<number[]>(server.sliders.map((slider) => slider.own));

  /** The file whose text it is, and what becomes of it. */
  readonly folder = new Folder(this);
  readonly isShared = server.isShared;
  readonly isNotebook = notebook !== null;
  writer: Writer | null = null;
  private reading = new Latest();
  private moving = new Latest(() => void server.leave("motion"));
  private passing = new Latest(); // of motions that give way to the next, which wait for no accurate one
  private nAsked = 0; // motions, and the last of them that is shown: what was asked for before it comes too late
  private nShown = 0;
  private curving = new Latest();
  private curvedAt = -Infinity; // [ms] when curves were asked for last
  private wholeAt = -Infinity; // [ms] when a motion came last
  private counting = new Latest(() => void server.leave("count"));
  private learning: Promise<void> | null = null;
  /** Of what the reader takes. */
  schema: Record<string, unknown> | null = null;

  constructor() {
    const language = notebook?.language ?? kept.get("language") ?? navigator.language.slice(0, 2);
    this.language = language === "de" ? "de" : "en";
    const [length, angle] = (kept.get("units") ?? "").split(" ");
    this.units = { length: LENGTHS.find((each) => each === length) ?? "m", angle: ANGLES.find((each) => each === angle) ?? "rad" };
    const shares = (kept.get("shares") ?? "").split(" ").map(Number);
    if (shares[0] && shares[1]) this.shares = { model: shares[0], results: shares[1] };
    this.theme = (kept.get("theme") as Theme | null) ?? (prefersDark.matches ? "dark" : "light");
    document.documentElement.dataset.theme = this.theme;
    prefersDark.addEventListener("change", () => {
      if (!kept.get("theme")) this.wear(prefersDark.matches ? "dark" : "light");
    });
  }

  word = (key: Word): string => WORDS[this.language][key];
  /** Keys as they are called on a keyboard of the language. */
  keys = (keys: string): string => keysIn(keys, this.language);

  /** A number of SI in words, in the units that are shown. */
  quantity = (value: number, unit: string): string => {
    const shown = unitIn(unit, this.units);
    return `${printed(value * shown.factor, this.language)} ${unitPrinted(shown.unit)}`;
  };
  /** A number that is written with a point, as the language writes it. */
  local = (number: string | number): string => local(String(number), this.language);
  /** Whether what is shown is that of the text as it stands. */
  get isCurrent(): boolean {
    return this.model !== null && this.modelText === this.text;
  }
  /** Whether the freedoms that are shown are those of the text as it stands; of a shared page they are those of its file. */
  get isCounted(): boolean {
    return this.isCurrent && (this.isShared || this.countText === this.text);
  }
  /** Whether what follows from the text as it stands is on its way: not that of a text that is no model, or could not be read. */
  get isAwaited(): boolean {
    return this.read?.is_model !== false && this.unread !== this.text;
  }
  get element(): Element | null {
    return this.read?.elements.find((e) => e.path.join(".") === this.selected) ?? null;
  }
  /** What is measured along the motion, in the units that are shown. */
  readonly lines = $derived(linesIn(this.curves?.lines ?? [], this.units));
  /** How far the picture reaches [m]. */
  get size(): number {
    const [x0, y0, x1, y1] = (this.motion?.player.bounds ?? [0, 0, 1, 1]) as [number, number, number, number];
    return Math.max(x1 - x0, y1 - y0);
  }
  /** The body that is selected, if it is one that moves. */
  get body(): string | null {
    const element = this.element;
    return element?.section === "bodies" && this.model?.moving.includes(element.name) ? element.name : null;
  }

  // -- the text
  /** What can be added and written: after the first picture, which does not wait for it. */
  async learn(): Promise<void> {
    if (this.isShared || this.isNotebook) return; // nothing is added there
    this.learning ??= this.asked("learn", { text: "" }).then((told) => {
      if (told?.answer) [this.kinds, this.schema] = [told.answer.kinds, told.answer.written];
      else this.learning = null;
    });
    await this.learning;
  }

  load(text: string): void {
    [this.motion, this.begun] = [null, null];
    this.curves = null;
    this.count = null;
    this.read = null;
    this.parameters = []; // their places are those of the other text
    this.model = null;
    this.modelText = "";
    this.time = 0;
    this.writer?.load(text);
  }

  /** The editor has another text. */
  changed(text: string): void {
    this.text = text;
    this.hand.stop();
    this.marks.changed();
    this.isStale = true;
    this.folder.changed();
    if (!this.read) this.readNow(); // nothing of it is shown yet
    else if (this.isSliding) this.readOnceAtRest();
    else this.readSoon();
  }

  private readSoon = debounced(60, () => this.readNow());
  /** The same once a slider rests: the accurate motion of one place would hold up that of the next. */
  private readOnceAtRest = debounced(AT_REST, () => this.readNow());

  readNow(): void {
    const text = this.text;
    this.reading.run(async () => {
      // the first motion of a text is asked for together with what it says: a picture waits for the longer of both
      const motion = !this.read && text.trim() ? this.askedMotion(text) : undefined;
      const told = await this.asked("read", { text, language: this.language });
      if (text !== this.text) return; // it is asked for again
      this.unread = told?.answer ? null : text;
      if (told && !told.answer) this.failure = this.reason(told);
      if (!told?.answer) return;
      [this.read, this.readText] = [told.answer, text];
      this.parameters = told.answer.parameters;
      if (!told.answer.is_model) return void this.learn(); // there is no picture to come first
      this.model = told.answer;
      this.modelText = text;
      this.follow(text, { asked: motion });
      if (!this.isNotebook) this.countSoon();
    });
  }

  private askedMotion(text: string, frames?: number): Promise<Told<"motion"> | null> {
    return this.asked("motion", this.motionOf(text, frames));
  }
  private motionOf(text: string, frames?: number) {
    return { text, language: this.language, until: this.until, frames, is_passing: frames === undefined ? undefined : true };
  }

  /** Follows the motion of the text as it stands. asked: where that has been asked for; frames: as many as the server thinks best. */
  follow(text = this.text, { frames, asked }: { frames?: number; asked?: Promise<Told<"motion"> | null> } = {}): void {
    const n = ++this.nAsked;
    (frames === undefined ? this.moving : this.passing).run(async () => {
      if (frames !== undefined && (await this.begins(text, n)) && this.passing.isWaiting && performance.now() - this.wholeAt < WHOLE_EVERY) return;
      const told = await (asked ?? this.askedMotion(text, frames));
      this.wholeAt = performance.now();
      if (!told || n < this.nShown) return;
      const isAbout = text === this.text && text === this.modelText;
      if (told.answer || (told.status !== "replaced" && isAbout)) {
        [this.motionText, this.nShown] = [text, n];
        this.isMoving = frames !== undefined;
        this.shown(told);
        this.curve(text, told, frames);
        void this.learn();
      }
      if (text === this.text) this.isStale = false;
    }, asked !== undefined);
  }
  /** Shows where the n-th motion starts before it is there, in the picture that is shown; whether that could be done. */
  private async begins(text: string, n: number): Promise<boolean> {
    if (!this.motion || this.time > this.motion.start || this.isNotebook) return false;
    const told = await this.asked("start", { text, language: this.language, like: this.motionText, is_passing: true });
    if (!told?.answer?.columns || n < this.nShown) return false;
    [this.begun, this.isMoving] = [told.answer.columns, true];
    return true;
  }
  /** What is measured along the motion that is shown: its picture does not wait for that. */
  private curve(text: string, shown: Told<"motion">, frames?: number): void {
    if (!shown.answer) this.curves = null;
    else if (this.passing.isWaiting && performance.now() - this.curvedAt < CURVES_EVERY) return;
    this.curvedAt = performance.now();
    this.curving.run(async () => {
      if (shown.answer !== this.motion || !shown.answer) return; // the next one is shown
      const told = await this.asked("curves", this.motionOf(text, frames));
      if (this.motion && told && told.status !== "replaced") this.curves = told.answer;
    });
  }

  /** On a shared page a slider shows a motion that was found beforehand. */
  movedTo(slider: number, place: number): void {
    this.places = this.places.map((each, k) => (k === slider ? place : each));
    const { motion, curves } = server.movedTo(this.places);
    this.shown(motion);
    this.curves = curves.answer;
  }
  get isMoved(): boolean {
    return server.sliders.some((slider, k) => slider.own !== this.places[k]);
  }
  private shown(told: Told<"motion">): void {
    [this.motion, this.begun] = [told.answer, null];
    this.motionMessage = told.answer ? told.answer.message : this.reason(told);
    if (told.answer) this.time = Math.min(this.time, told.answer.end);
  }

  private countSoon = debounced(250, () => {
    const text = this.modelText;
    this.counting.run(async () => {
      const told = await this.asked("count", { text, language: this.language, name: "mobility", prefix: "count-" });
      if (text !== this.modelText) return; // the next one is on its way
      if (told?.answer) [this.count, this.countText] = [told.answer, text];
      else if (told && told.status !== "replaced") this.count = null;
    });
  });

  setUntil(seconds: number): void {
    if (!(seconds > 0 && seconds <= 1e4)) return;
    this.until = seconds;
    kept.set(`until.${this.folder.file}`, String(seconds));
    this.follow();
  }

  /** A parameter gets another text; the motion follows at once, without waiting for the rest. */
  setParameter(parameter: Parameter, text: string): void {
    const { start, end } = parameter.span;
    if (this.text.slice(start, end) !== parameter.text) return; // its place is not known until the text is read
    this.follow(this.text.slice(0, start) + text + this.text.slice(end), { frames: FEWER }); // on its way meanwhile
    this.isSliding = true;
    this.marks.while(parameter.name, () => this.writer?.change([{ from: start, to: end, insert: text }], "input.type.slider"));
    this.isSliding = false;
  }

  /** Places of parameters after a change, until the text is read again. */
  moved(map: (place: number, side: number) => number, text: string): void {
    this.parameters = this.parameters.map((p) => {
      const span = { start: map(p.span.start, -1), end: map(p.span.end, 1) };
      const now = text.slice(span.start, span.end);
      return { ...p, span, text: /[,:{}\n]/.test(now) ? p.text : now }; // a change that took more than this value
    });
  }

  /** Makes another text of this one, by the smallest change. */
  rewrite(text: string, userEvent: string): void {
    const change = changeBetween(this.text, text);
    if (change) this.writer?.change([change], userEvent);
  }

  /** Changes the text as an answer to it says; where it has changed meanwhile, by what is answered to the new one. */
  async changeBy<K extends "edit" | "rename" | "add" | "join">(kind: K, request: Omit<Requests[K], "text" | "language">, userEvent: string): Promise<Answers[K] | null> {
    for (const file = this.folder.file; file === this.folder.file; ) {
      const text = this.text;
      const told = await this.asked(kind, { ...request, text, language: this.language } as Requests[K]);
      if (told?.answer && text !== this.text) continue;
      if (told?.answer) this.rewrite(told.answer.text, userEvent);
      else if (told) this.failure = this.reason(told);
      return told?.answer ?? null;
    }
    return null; // another file was opened
  }

  async setValue(path: (string | number)[], value: string | null): Promise<void> {
    await this.changeBy("edit", { path, value }, "input.property");
  }

  /** What is at a path gets another name, wherever the text has it. */
  async rename(path: (string | number)[], name: string): Promise<void> {
    if (await this.changeBy("rename", { path, name }, "input.rename")) this.selected = [...path.slice(0, -1), name.trim()].join(".");
  }

  /** A new element; value: its YAML, in one line. */
  async add(section: string, name: string, value: string): Promise<boolean> {
    return (await this.changeBy("add", { section, name, value }, "input.add")) !== null;
  }

  // -- asking
  async asked<K extends keyof Answers>(kind: K, request: Parameters<typeof server.ask<K>>[1], topic?: string): Promise<Told<K> | null> {
    try {
      const told = await server.ask(kind, request, topic);
      this.answered();
      return told;
    } catch (error) {
      this.fail(error);
      return null;
    }
  }

  /** The page of the model as one file. vary: what its sliders move */
  sharedPage(vary: string[], topic?: string): Promise<Told<"share"> | null> {
    return this.asked("share", { text: this.modelText, language: this.language, until: this.until, name: this.folder.file, vary }, topic);
  }

  /** Why there is no answer, in words. */
  reason(told: { status: string; message: string }): string {
    if (told.status === "cancelled") return this.word("cancelled");
    if (told.status === "too long") return this.word("tooLong");
    if (told.status === "crashed") return `${this.word("crashed")} (${told.message})`;
    return wordsPrinted(told.message);
  }

  fail(error: unknown): void {
    if (!(error instanceof server.Unreachable)) this.failure = error instanceof Error ? error.message : String(error);
    else if (error.status === 0) this.isLost = true;
    else this.failure = error.status === 401 ? this.word("otherStart") : error.message;
  }
  /** The server is there: after it was not, all that is shown is asked for again. */
  answered(): void {
    if (!this.isLost) return;
    this.isLost = false;
    this.nReturns += 1;
    this.readNow();
  }

  // -- the view
  setLanguage(language: Language): void {
    this.language = language;
    kept.set("language", language);
    this.readNow();
  }
  setTheme(theme: Theme): void {
    kept.set("theme", theme);
    this.wear(theme);
  }
  setUnits(units: Units): void {
    this.units = units;
    kept.set("units", `${units.length} ${units.angle}`);
  }
  /** Colours are read from the page by what follows, so they are there first. */
  wear(theme: Theme): void {
    document.documentElement.dataset.theme = theme;
    this.theme = theme;
  }
  /** An outer pane gets so many hundredths of the width, as far as all three stay usable. */
  setShare(pane: keyof typeof SHARES, share: number): void {
    const other = this.shares[pane === "model" ? "results" : "model"];
    const width = Math.max(NARROWEST, Math.min(share, 100 - LEAST_SCENE - other));
    this.shares = { ...this.shares, [pane]: width };
    kept.set("shares", `${this.shares.model} ${this.shares.results}`);
  }
  select(path: string | null, show = true): void {
    this.selected = path;
    const element = this.element;
    if (element && show) this.writer?.select(element.name_span.start, element.name_span.end);
  }
  derive(question: string): void {
    this.derived = question;
    this.panel = "derivation";
  }
}

export const studio = new Studio();

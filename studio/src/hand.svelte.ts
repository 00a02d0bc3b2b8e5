// What is done by hand in the scene: bodies are dragged, and elements made by pointing at what they join.
import { Latest } from "./latest";
import type { Studio } from "./state.svelte";
import type { Place } from "virtual:player";
import type { End, Kind, Spot } from "./wire";

/** Frames of a motion while something is moved by hand. */
export const FEWER = 61;

/** An element that is being made by pointing: what can be pointed at, what was, and what would come of it. */
export interface Joining {
  text: string;
  kind: Kind;
  spots: Spot[];
  ends: End[];
  preview: string;
}

/** Of a dragged point: where it is at the start, and where to. */
export interface Pull {
  grabbed: Place;
  to: Place;
}

export class Hand {
  joining = $state.raw<Joining | null>(null);
  private dragging = new Latest();
  private looking = new Latest();
  private draggedTo = "";

  constructor(private studio: Studio) {}

  /** Whether elements of a kind can be made by pointing. */
  canPoint(kind: Kind): boolean {
    return kind.ends.length > 0 && this.studio.isCurrent && this.studio.motion !== null && !this.studio.model!.is_spatial;
  }
  async begin(kind: Kind): Promise<void> {
    const text = this.studio.text;
    const told = await this.studio.asked("spots", { text, language: this.studio.language });
    if (!told?.answer) {
      if (told) this.studio.failure = this.studio.reason(told);
      return;
    }
    if (text !== this.studio.text) return;
    [this.studio.dialog, this.studio.pane, this.studio.time] = ["", "scene", 0];
    this.joining = { text, kind, spots: told.answer.spots, ends: [], preview: "" };
  }
  stop(): void {
    this.joining = null;
  }
  /** What would come of pointing at an end, where it is the last one. */
  preview(end: End | null): void {
    const joining = this.joining;
    if (!joining) return;
    if (joining.preview) this.joining = { ...joining, preview: "" };
    const ends = end ? [...joining.ends, end] : [];
    this.looking.run(async () => {
      if (ends.length !== joining.kind.ends.length) return;
      const { text, kind: { section, kind } } = joining;
      // under a topic of its own: it takes no place of what is added
      const told = await this.studio.asked("join", { text, language: this.studio.language, section, kind, ends }, "preview");
      if (this.joining?.ends !== joining.ends || !told || told.status === "replaced") return;
      this.joining = { ...this.joining, preview: told.answer?.value ?? this.studio.reason(told) };
    });
  }
  async point(end: End): Promise<void> {
    const joining = this.joining;
    if (!joining) return;
    const ends = [...joining.ends, end];
    if (ends.length < joining.kind.ends.length) {
      this.joining = { ...joining, ends, preview: "" };
      return;
    }
    const { section, kind } = joining.kind;
    const joined = await this.studio.changeBy("join", { section, kind, ends }, "input.add");
    if (joined) [this.studio.selected, this.studio.panel] = [joined.path.join("."), "properties"];
  }

  /** Brings a point of a body from one place at the start to another, as far as it goes: by the first pull that moves it. */
  drag(text: string, body: string, pulls: Pull[], sides: [Place, Place]): void {
    this.dragging.run(async () => {
      for (const pull of pulls) {
        const told = await this.studio.asked("drag", { text, language: this.studio.language, body, ...pull, across: sides[0], up: sides[1] });
        if (this.studio.text !== text && this.studio.text !== this.draggedTo) return; // undone, or changed otherwise, meanwhile
        if (told?.answer && told.answer.text !== this.studio.text) { // which may be back where it was
          this.draggedTo = told.answer.text;
          this.studio.rewrite(told.answer.text, "input.type.drag");
          return this.studio.follow(this.studio.text, { frames: FEWER });
        }
        if (!told || told.status === "replaced") return;
        if (!told.answer) this.studio.failure = this.studio.reason(told);
      }
    });
  }
  /** Whether a body is shown where the text has it, and can be dragged from there. */
  canDrag(body: string | null | undefined): body is string {
    const isAtStart = this.studio.motion !== null && this.studio.time <= this.studio.motion.start;
    return !this.studio.isShared && isAtStart && this.studio.isCurrent && this.studio.motionText === this.studio.text && Boolean(body && this.studio.model?.moving.includes(body));
  }
}

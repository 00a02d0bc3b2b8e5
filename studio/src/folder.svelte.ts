// The file whose text is shown: opened, saved, followed where another program writes it, and kept as a draft meanwhile.
import * as drafts from "./drafts";
import { kept, keptByWindow } from "./kept";
import { debounced } from "./latest";
import { hearText, notebook, tellText } from "./notebook";
import * as server from "./server";
import type { Studio } from "./state.svelte";
import type { OpenedFile } from "./wire";
import type { Word } from "./words";

export class Folder {
  file = $state("model.yaml");
  isOpen = false; // until the first file is there nothing can be typed
  files = $state<string[]>([]);
  version = $state("");
  savedText = $state("");
  draft = $state.raw<drafts.Draft | null>(null);
  /** The file as another program, or another window, has written it meanwhile. */
  other = $state.raw<OpenedFile | null>(null);
  /** What has happened by itself. */
  told = $state<Word | "">("");
  release = $state("");
  hasFfmpeg = $state(false); // without it no video can be coded
  usual = 3; // [s] that a motion is followed, as the server says
  private opening = server.open(); // on its way while the page is made
  private nOpened = 0;
  private nAsked = 0;
  private saving: Promise<void> = Promise.resolve();

  constructor(private studio: Studio) {
    this.opening.catch(() => undefined); // `begin` says it
  }

  get isSaved(): boolean {
    return this.studio.text === this.savedText;
  }

  async begin(): Promise<void> {
    try {
      const opening = await this.opening, before = this.viewBefore();
      this.files = opening.files;
      this.release = opening.version;
      this.usual = opening.until;
      this.hasFfmpeg = opening.has_ffmpeg;
      const file = before && before.file !== opening.file.name ? await server.openFile(before.file) : opening.file;
      this.take(file.name, file.text, file.version);
      if (before) this.restore(before);
      else if (!file.text) {
        if (opening.is_file) this.studio.load("");
        else this.studio.dialog = "gallery";
      }
      if (this.studio.isNotebook) hearText((text) => this.studio.rewrite(text, "input.kernel"));
    } catch (error) {
      this.studio.fail(error);
    }
  }

  /** Shows a file, as this window has left it; what another one has left is offered. What was typed into the one
   * before is kept. */
  take(name: string, text: string, version: string): void {
    if (this.isOpen) this.keepDraftNow();
    this.isOpen = true;
    this.nOpened += 1;
    [this.file, this.version, this.savedText] = [name, version, text];
    [this.draft, this.other, this.told, this.studio.asking, this.studio.question, this.studio.derived] = [null, null, "", null, "", null];
    this.studio.until = notebook?.until ?? (Number(kept.get(`until.${name}`)) || this.usual);
    this.studio.selected = null;
    const own = this.hasDrafts ? drafts.ownOf(name) : null;
    this.studio.load(text);
    if (own !== null && own !== text) {
      this.studio.rewrite(own, "input.draft");
      this.told = "restored";
    }
    void this.offer();
  }
  private get hasDrafts(): boolean {
    return !this.studio.isShared && !this.studio.isNotebook;
  }

  /** The latest of what windows that are gone have left of this file. */
  private async offer(): Promise<void> {
    if (!this.hasDrafts) return;
    const n = this.nOpened, [latest] = await drafts.left(this.file, this.studio.text);
    if (n === this.nOpened) this.draft = latest ?? null;
  }
  takeDraft(): void {
    if (this.draft) this.studio.rewrite(this.draft.text, "input.draft");
    this.dropDraft();
  }
  dropDraft(): void {
    if (this.draft) drafts.drop(this.draft);
    this.draft = null;
    void this.offer();
  }

  // -- what this window shows, when its page is loaded anew
  private viewBefore() {
    if (!drafts.isReloaded || !this.hasDrafts) return null;
    try {
      return JSON.parse(keptByWindow.get("view") ?? "null") as ReturnType<Folder["view"]> | null;
    } catch {
      return null;
    }
  }
  private view() {
    const { file, version, savedText } = this, { panel, pane, selected, time, derived, asking, shows, freed, isApart } = this.studio;
    return { file, version, savedText, panel, pane, selected, time, derived, asking, shows: [...shows], freed: [...freed], isApart, editor: this.studio.writer?.kept() };
  }
  private restore(view: ReturnType<Folder["view"]>): void {
    // what the text was made of: if the file is another one now, that is told
    [this.version, this.savedText] = [view.version, view.savedText];
    if (view.editor) this.studio.writer?.restore(view.editor);
    this.told = "";
    const { panel, pane, selected, time, derived, asking } = view;
    [this.studio.shows, this.studio.freed, this.studio.isApart] = [view.shows ?? [], view.freed ?? [], view.isApart ?? true];
    [this.studio.panel, this.studio.pane, this.studio.selected, this.studio.time, this.studio.derived] = [panel, pane, selected, time, derived];
    [this.studio.asking, this.studio.question] = [asking, asking ?? ""];
    void this.lookAtFile();
  }
  /** When the page may be gone soon. */
  keepAll(): void {
    if (!this.isOpen || !this.hasDrafts) return;
    this.keepDraftNow();
    keptByWindow.set("view", JSON.stringify(this.view()));
  }

  /** The dialog stays until the file is there: what is typed meanwhile would go into the one before. Of two that are
   * opened the later one is shown. */
  async openFile(name: string): Promise<void> {
    const n = (this.nAsked += 1), before = this.nOpened;
    try {
      const file = await server.openFile(name);
      if (n !== this.nAsked || before !== this.nOpened) return;
      this.studio.dialog = "";
      this.take(file.name, file.text, file.version);
    } catch (error) {
      this.studio.fail(error);
    }
  }

  /** One after the other: the next one is about what the one before has written. */
  save(overwrite = false, name = this.file): Promise<void> {
    this.saving = this.saving.then(() => this.saveNow(overwrite, name));
    return this.saving;
  }
  private async saveNow(overwrite: boolean, name: string): Promise<void> {
    const { file } = this, { text } = this.studio, n = this.nOpened;
    try {
      const version = name === file ? this.version : "";
      const done = await server.save({ name, text, version, overwrite, language: this.studio.language });
      const isShown = n === this.nOpened; // else another file was opened meanwhile
      if (done.is_changed) {
        if (isShown) this.studio.dialog = "changed";
        return this.lookAtFile();
      }
      if (done.message) {
        this.studio.failure = done.message;
        return;
      }
      for (const each of [file, name]) drafts.keep(each, null);
      if (!this.files.includes(name)) this.files = [...this.files, name].sort();
      if (!isShown) return;
      if (["save", "changed"].includes(this.studio.dialog)) this.studio.dialog = "";
      [this.file, this.version, this.savedText, this.studio.failure] = [name, done.version, text, ""];
      [this.other, this.told] = [null, ""];
      kept.set("saved", `${name} ${done.version}`); // which other windows hear
    } catch (error) {
      this.studio.fail(error);
    }
  }

  /** Whether the file is still what it was. Where nothing is lost by it, the page follows; else it asks. */
  async lookAtFile(): Promise<void> {
    if (!this.isOpen || !this.hasDrafts) return;
    const n = this.nOpened, { file, version } = this;
    try {
      const found = await server.openFile(file);
      this.studio.answered();
      if (n !== this.nOpened || version !== this.version || !found.version) return;
      if (found.version === version) this.other = null;
      else if (found.text === this.studio.text) [this.version, this.savedText, this.other] = [found.version, found.text, null];
      else if (version && this.isSaved) this.takeOther(found);
      else if (this.other?.version !== found.version) this.other = found;
    } catch (error) {
      if (error instanceof server.Unreachable && error.status !== 409) this.studio.fail(error);
    }
  }
  /** The text becomes that of the file, which can be undone. */
  takeOther(other: OpenedFile): void {
    [this.version, this.savedText, this.other, this.studio.dialog] = [other.version, other.text, null, ""];
    this.studio.rewrite(other.text, "input.file");
    this.told = "followed";
  }
  /** The text stays: saved, it takes the place of what the other one has written. */
  keepOwn(): void {
    if (this.other) this.version = this.other.version;
    this.other = null;
  }

  /** The text is another one. */
  changed(): void {
    if (this.told) this.told = "";
    if (this.studio.isNotebook) this.keepInKernel();
    else this.keepDraft();
  }
  /** In a notebook the kernel has the text: there is nothing to save. */
  private keepInKernel(): void {
    if (this.studio.text !== this.savedText) tellText(this.studio.text);
    this.savedText = this.studio.text;
  }

  private keepDraft = debounced(500, () => this.keepDraftNow());
  private keepDraftNow(): void {
    if (this.hasDrafts && this.isOpen) drafts.keep(this.file, this.isSaved ? null : this.studio.text);
  }
}

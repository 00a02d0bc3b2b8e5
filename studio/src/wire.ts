// Written by tools/write_studio_types.py from freebody/studio/wire: do not edit.

/** Add an element at the end of a section, under its name or the next that is free. value: its YAML in one line */
export interface AddRequest {
  text: string;
  language?: "en" | "de";
  section: string;
  name: string;
  value: string;
}

/** vector: along the axes of the ground; of a couple its moment. owner: the connection or load; of: the row or push, as pictures mark it */
export interface Arrow {
  kind: string;
  label: string;
  body: string;
  times: number[];
  at: ((number | null)[])[];
  vector: ((number | null)[])[];
  is_couple: boolean;
  owner: string;
  of: string;
}

/** A question of the file. text: in the language of the page where its words are those of the grammar */
export interface Asked {
  id: string;
  text: string;
}

/** What the page posts. topic: a later request of the same topic takes the place of an earlier one; each window has its own; number: which of a window's requests it is, so that what is left before it is asked is not this one */
export interface Call {
  kind: string;
  topic: string;
  request: Record<string, unknown>;
  number?: number;
}

/** Within which dry friction holds. axis: of the normal force; half: angle to its sides [rad]; used: to the resultant */
export interface Cone {
  kind: string;
  label: string;
  body: string;
  times: number[];
  at: ((number | null)[])[];
  axis: ((number | null)[])[];
  half: number;
  used: (number | null)[];
}

/** What is measured along a motion. recordable: the names of those lines of which a sweep records a value; energy_error: relative */
export interface CurvesAnswer {
  times: number[];
  lines: Line[];
  recordable: string[];
  energy_error: number | null;
}

/** Bring a point of a body, at the place `grabbed` [m] at the start, as near `to` another place as it goes in a picture. across, up: what runs right and up in it, along the axes of the ground; how deep a point lies is free */
export interface DragRequest {
  text: string;
  language?: "en" | "de";
  body: string;
  grabbed: number[];
  to: number[];
  across?: [number, number, number];
  up?: [number, number, number];
}

/** Something that moves over the scene. body: along whose axes its place is given, from its mass centre; empty for the ground; times: [s]; at: for each of three axes one number a time, or one for all; nothing where it is not */
export interface Drawn {
  kind: string;
  label: string;
  body: string;
  times: number[];
  at: ((number | null)[])[];
}

/** Set the value at a path, as the YAML of a scalar; None takes it out. */
export interface EditRequest {
  text: string;
  language?: "en" | "de";
  path: (string | number)[];
  value: string | null;
}

/** A named part of the model. kind: what it is, as the file says; name_span: of its name; span: of name and value */
export interface Element {
  section: string;
  name: string;
  kind: string;
  path: (string | number)[];
  name_span: Span;
  span: Span;
  leaves: Leaf[];
}

/** What was pointed at: a spot by its name; without one, a place [m] on the ground. */
export interface End {
  name: string;
  at: [number, number];
}

/** A bundled model. name: of its file */
export interface Example {
  name: string;
  title: string;
  text: string;
  is_template: boolean;
}

/** The same as files. */
export interface ExportRequest {
  text: string;
  language?: "en" | "de";
  name: string;
  options?: Record<string, string | boolean | number | string[]>;
  prefix?: string;
  format?: "html" | "md" | "tex" | "pdf" | "ipynb" | "txt" | "json";
}

/** A file to be kept. content: in base64 */
export interface File {
  name: string;
  content: string;
}

/**  */
export interface FilesAnswer {
  files: File[];
}

/** A change that mends a problem: the text in a span is replaced. */
export interface Fix {
  label: string;
  span: Span;
  text: string;
}

/** An event of a motion at a time [s]. */
export interface Happening {
  time: number;
  name: string;
}

/**  */
export interface HintsAnswer {
  hints: string[];
}

/** Hints to a question of the file. question: its id */
export interface HintsRequest {
  text: string;
  language?: "en" | "de";
  question: string;
}

/** The changed text, and the path to the new element in it, with its value in one line. */
export interface JoinAnswer {
  text: string;
  path: string[];
  value: string;
}

/** Add an element of a kind between what was pointed at, as many as the kind has ends. */
export interface JoinRequest {
  text: string;
  language?: "en" | "de";
  section: string;
  kind: string;
  ends: End[];
}

/** html: the verdict; plain: the same as data; is_attempt: whether it counts, as what cannot be read does not */
export interface JudgeAnswer {
  html: string;
  plain: Record<string, unknown>;
  is_right: boolean;
  is_attempt: boolean;
}

/** Judge what somebody answers to a question, or the forces that are said to act on bodies cut free. prefix: of the names in the HTML */
export interface JudgeRequest {
  text: string;
  language?: "en" | "de";
  question?: string;
  free?: string[];
  answer: string;
  prefix?: string;
}

/** What a section may have. value: of the smallest example, as YAML in one line; about: what it is; ends: the paths in its value of what it joins */
export interface Kind {
  section: string;
  kind: string;
  value: string;
  about: string;
  ends: ((string | number)[])[];
}

/** A value in the text that can be changed. path: to it; label: the last parts of it; text: as it stands there */
export interface Leaf {
  path: (string | number)[];
  label: string;
  text: string;
  span: Span;
}

/** What can be added to a model, and the JSON Schema of its text. */
export interface LearnAnswer {
  kinds: Kind[];
  written: Record<string, unknown>;
}

/** Say what can be added and written, whatever the model. */
export interface LearnRequest {
  text?: string;
  language?: "en" | "de";
}

/** One curve, over the times of a motion or the cases of a sweep. math: its symbol in MathML, where it has one */
export interface Line {
  name: string;
  label: string;
  math: string;
  unit: string;
  values: (number | null)[];
}

/** A number, in the unit of the slider of a parameter, at which some conditions change their truth. words: theirs */
export interface Mark {
  name: string;
  at: number;
  words: string[];
}

/**  */
export interface MarksAnswer {
  marks: Mark[];
}

/** Say where something changes along sliders. until: the time [s] within which motions are looked at */
export interface MarksRequest {
  text: string;
  language?: "en" | "de";
  ranges: Range[];
  until?: number;
}

/** What a symbol speaks of. symbol: as it is shown, without its subscripts' places; owner: a connection or load, or nothing; forces: what acts, as pictures mark it */
export interface Meaning {
  symbol: string;
  bodies: string[];
  owner: string;
  forces: string[];
}

/** Cases of a sweep without a number: how many of a status, at which value the first of them is, and why. */
export interface Missing {
  status: string;
  count: number;
  first: number;
  why: string;
}

/** player: what `player.js` draws; start, end: of what could be followed [s]; is_complete: whether that is all of the time, else message says why */
export interface MotionAnswer {
  player: Record<string, unknown>;
  start: number;
  end: number;
  events: Happening[];
  is_complete: boolean;
  message: string;
}

/** Follow the motion to the time `until` [s]. is_passing: for a picture that soon gives way to the next, as while a slider is moved, so that it needs no more accuracy than can be seen */
export interface MotionRequest {
  text: string;
  language?: "en" | "de";
  until: number;
  frames?: number;
  is_passing?: boolean;
}

/** The motions of all values of some sliders, the last of which runs fastest. replies: of `player` what differs from that of the file's values; curves: of each; answers: to the questions of the file */
export interface Moved {
  sliders: Slider[];
  replies: Reply[];
  curves: Reply[];
  answers: Valued[];
}

/** A file of the opened folder. version: changes with its content, empty for one that is not there yet */
export interface OpenedFile {
  name: string;
  text: string;
  version: string;
}

/** What the page begins with. is_file: whether a file was named; until: to which time [s] a motion is followed unless somebody chooses; has_ffmpeg: whether videos can be coded here */
export interface Opening {
  file: OpenedFile;
  files: string[];
  is_file: boolean;
  version: string;
  until: number;
  has_ffmpeg: boolean;
}

/** scales: by kind; messages: why something is not there */
export interface OverlaysAnswer {
  arrows: Arrow[];
  spots: Drawn[];
  cones: Cone[];
  scales: Record<string, Scale>;
  messages: string[];
}

/** Say what is drawn over that motion. */
export interface OverlaysRequest {
  text: string;
  language?: "en" | "de";
  until: number;
  frames?: number;
  is_passing?: boolean;
  show: ("velocity" | "acceleration" | "reaction" | "load" | "friction-cones" | "mass-centres" | "instant-centres")[];
}

/** The motion as a file: a page that plays without a server, moving pictures, or all that is measured along it. */
export interface PageRequest {
  text: string;
  language?: "en" | "de";
  until: number;
  frames?: number;
  is_passing?: boolean;
  format?: "html" | "gif" | "mp4" | "csv" | "nc" | "parquet";
}

/** A number that can be moved: a parameter, or a value of the start. symbol: as pictures have it; math: in MathML, empty where the name is no symbol; text: as it stands in the file, with its unit */
export interface Parameter {
  name: string;
  symbol: string;
  math: string;
  section: "parameters" | "start";
  text: string;
  span: Span;
  is_positive: boolean;
}

/** content: of the picture, bytes in base64; meanings: of symbols in it, where bodies are cut free */
export interface PictureAnswer {
  content: string;
  meanings: Meaning[];
}

/** Draw the model, or bodies of it cut free. */
export interface PictureRequest {
  text: string;
  language?: "en" | "de";
  free?: string[];
  at?: number | null;
  show?: string[];
  dark?: boolean | null;
  format?: "svg" | "png" | "pdf" | "tex";
}

/** html: a question as an exercise asks it, with its options; options: their letters */
export interface PosedAnswer {
  html: string;
  options: string[];
}

/** How a question of the file is asked. prefix: of the names in the HTML */
export interface PosedRequest {
  text: string;
  language?: "en" | "de";
  question: string;
  prefix?: string;
}

/** Between which numbers, in which unit, a slider moves a parameter. */
export interface Range {
  name: string;
  low: number;
  high: number;
  unit: string;
}

/** A text that has been read. is_model: whether it is one; then everything else is known */
export interface ReadAnswer {
  is_model: boolean;
  title: string;
  about: string;
  is_spatial: boolean;
  remarks: Remark[];
  elements: Element[];
  parameters: Parameter[];
  questions: Asked[];
  moving: string[];
}

/** Read a model. */
export interface ReadRequest {
  text: string;
  language?: "en" | "de";
}

/** What is wrong with a text, or unlikely in it. where: the path in words; line: from 1, 0 where it is unknown */
export interface Remark {
  severity: "error" | "warning";
  message: string;
  where: string;
  line: number;
  span: Span;
  fixes: Fix[];
}

/** Give what is at a path another name, wherever the text has it. */
export interface RenameRequest {
  text: string;
  language?: "en" | "de";
  path: (string | number)[];
  name: string;
}

/** What comes back. done: answer is there; refused: the model or the question is at fault; else the work was not finished: replaced by a later request, cancelled, out of time or memory, or the worker ended. later: it takes its time, and comes under the number in the message */
export interface Reply {
  status: "done" | "refused" | "replaced" | "cancelled" | "too long" | "crashed" | "later";
  message: string;
  answer: unknown;
}

/** What every request has: the text of the model, and the language of messages. */
export interface Request {
  text: string;
  language?: "en" | "de";
}

/** version: the new one; is_changed: the file has been changed by somebody else, and nothing was written; message: why nothing was written, empty if it was */
export interface SaveAnswer {
  version: string;
  is_changed: boolean;
  message: string;
}

/** Write a file of the folder. version: of what it was opened from; what another program has changed since is kept unless this says otherwise */
export interface SaveRequest {
  name: string;
  text: string;
  version: string;
  overwrite?: boolean;
  language?: "en" | "de";
}

/** How long arrows of a kind are drawn. largest: along the motion; by_root: whether as the root of the size */
export interface Scale {
  largest: number;
  by_root: boolean;
}

/** The page of the studio with all its answers in it, as one file. name: of the model file; vary: what sliders move, as "L=0.5..2 m:9" */
export interface ShareRequest {
  text: string;
  language?: "en" | "de";
  until: number;
  frames?: number;
  is_passing?: boolean;
  name?: string;
  vary?: string[];
}

/** A name whose motions were found beforehand. values: as they are written; own: the place of the file's value among them */
export interface Slider {
  name: string;
  values: string[];
  own: number;
}

/** Where something stands in the text. */
export interface Span {
  start: number;
  end: number;
}

/** A point, a body or a line that can be pointed at, where it is [m] at the start. */
export interface Spot {
  name: string;
  body: string;
  at: [number, number];
}

/**  */
export interface SpotsAnswer {
  spots: Spot[];
}

/** columns: of the player at the start, one number each; nothing where the picture is another one */
export interface StartAnswer {
  columns: number[] | null;
}

/** Say where bodies start, for a picture that is there already. like: the text of the motion that it shows; is_passing: as of a motion */
export interface StartRequest {
  text: string;
  language?: "en" | "de";
  like: string;
  is_passing?: boolean;
}

/** html: the report; plain: the same as data; is_complete: whether all that was asked is found; meanings: of symbols in it */
export interface StudyAnswer {
  html: string;
  plain: Record<string, unknown>;
  is_complete: boolean;
  meanings: Meaning[];
}

/** Do one of the table of studies. options: as words of the command line, by the name of the parameter; prefix: of the names in the HTML. */
export interface StudyRequest {
  text: string;
  language?: "en" | "de";
  name: string;
  options?: Record<string, string | boolean | number | string[]>;
  prefix?: string;
}

/** understood: how the grammar puts the question, in the language of the page, empty if it cannot be read; then why: message */
export interface SuggestAnswer {
  understood: string;
  message: string;
  suggestions: Suggestion[];
}

/** What a question that is being typed means, and others that are near. */
export interface SuggestRequest {
  text: string;
  language?: "en" | "de";
  question: string;
}

/** question: in the words of the grammar, to be asked; said: the same in the language of the page */
export interface Suggestion {
  question: string;
  said: string;
}

/** What comes of a name at each of its values, in its unit. about: what was looked at; statuses: of each case in words */
export interface SweepAnswer {
  name: string;
  unit: string;
  values: number[];
  about: string;
  lines: Line[];
  statuses: string[];
  missing: Missing[];
}

/** Vary one name from `low` to `high`, quantities as in a file, in n cases. find: a question, by its id or in words; record: of the motion to the time `until` [s], as "maximum of theta"; one of both */
export interface SweepRequest {
  text: string;
  language?: "en" | "de";
  name: string;
  low: string;
  high: string;
  n: number;
  find?: string;
  record?: string;
  until?: number;
}

/** The changed text. */
export interface TextAnswer {
  text: string;
}

/** A question of the file in all places of the sliders. values: numbers with units, or why there is none */
export interface Valued {
  id: string;
  text: string;
  values: string[];
}

export interface Requests {
  read: ReadRequest;
  edit: EditRequest;
  rename: RenameRequest;
  add: AddRequest;
  drag: DragRequest;
  spots: Request;
  join: JoinRequest;
  suggest: SuggestRequest;
  motion: MotionRequest;
  start: StartRequest;
  curves: MotionRequest;
  overlays: OverlaysRequest;
  learn: LearnRequest;
  marks: MarksRequest;
  changes: MarksRequest;
  picture: PictureRequest;
  judge: JudgeRequest;
  posed: PosedRequest;
  hints: HintsRequest;
  count: StudyRequest;
  study: StudyRequest;
  sweep: SweepRequest;
  export: ExportRequest;
  page: PageRequest;
  share: ShareRequest;
}

export interface Answers {
  read: ReadAnswer;
  edit: TextAnswer;
  rename: TextAnswer;
  add: TextAnswer;
  drag: TextAnswer;
  spots: SpotsAnswer;
  join: JoinAnswer;
  suggest: SuggestAnswer;
  motion: MotionAnswer;
  start: StartAnswer;
  curves: CurvesAnswer;
  overlays: OverlaysAnswer;
  learn: LearnAnswer;
  marks: MarksAnswer;
  changes: MarksAnswer;
  picture: PictureAnswer;
  judge: JudgeAnswer;
  posed: PosedAnswer;
  hints: HintsAnswer;
  count: StudyAnswer;
  study: StudyAnswer;
  sweep: SweepAnswer;
  export: FilesAnswer;
  page: FilesAnswer;
  share: FilesAnswer;
}

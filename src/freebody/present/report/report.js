"use strict";
const steps = [...document.querySelectorAll(".step > details")];
const bar = document.querySelector(".bar");
const [nextButton, allButton, count] = bar.children;
const isHidden = (step) => step.parentElement.closest("details:not([open])") !== null;
function refresh() {
  const open = steps.filter((step) => step.open).length;
  count.textContent = `${open} / ${steps.length}`;
  bar.hidden = open === steps.length;
}
function show(step) {
  step.open = true;
  const smooth = !matchMedia("(prefers-reduced-motion: reduce)").matches;
  step.querySelector("summary").focus({ preventScroll: true });
  step.parentElement.scrollIntoView({ block: "start", behavior: smooth ? "smooth" : "auto" });
}
function showNext() {
  const step = steps.find((step) => !step.open && !isHidden(step));
  if (step) show(step);
}
function showAll() { for (const step of steps) step.open = true; }
nextButton.onclick = showNext;
allButton.onclick = showAll;
for (const step of steps) step.addEventListener("toggle", refresh);
document.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  if (event.key === "n") showNext();
  if (event.key === "a") showAll();
});
// A link to something inside a closed step opens it.
function reveal() {
  const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  for (let step = target?.closest("details"); step; step = step.parentElement.closest("details")) step.open = true;
  target?.scrollIntoView();
}
addEventListener("hashchange", reveal);
// On paper every step is open.
let closed = [];
addEventListener("beforeprint", () => { closed = steps.filter((step) => !step.open); showAll(); });
addEventListener("afterprint", () => { for (const step of closed) step.open = false; });
refresh();
if (location.hash) reveal();

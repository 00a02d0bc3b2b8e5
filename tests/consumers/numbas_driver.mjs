// Puts the self-tests of exams to Numbas: its compiler (bin/numbas.py), then its own runtime without a page.
//
//     node numbas_driver.mjs <checkout of Numbas, with jsdom> <python with jinja2> <package> ...
//
// Printed is a list, for each package, of what became of its answers: `question`, `what`, `response`, `wanted`, `credit`,
// `said` (whether the wanted feedback was given), `seconds`, `error`. The exam is loaded as in a browser, by
// Numbas.load_exam from the compiled numbas.js; only XSLT, which jsdom lacks, is replaced by the content of the node.

import { spawnSync } from 'node:child_process';
import fs from 'node:fs';
import { createRequire } from 'node:module';
import os from 'node:os';
import path from 'node:path';
import vm from 'node:vm';

const [checkout, python, ...packages] = process.argv.slice(2).map((each, k) => (k === 1 ? each : path.resolve(each)));
const { JSDOM } = createRequire(path.join(checkout, 'package.json'))('jsdom');

function compiled(folder) {
  const out = fs.mkdtempSync(path.join(os.tmpdir(), 'numbas-'));
  const source = path.join(folder, 'questions.exam');
  const made = spawnSync(python, ['bin/numbas.py', '-p', checkout, '-c', '-o', out, source], { cwd: checkout });
  const built = path.join(out, 'numbas.js');
  if (made.status !== 0 || !fs.existsSync(built)) throw new Error(`not compiled: ${made.stdout}${made.stderr}`);
  const [code, exam] = [built, path.join(out, 'source.exam')].map((file) => fs.readFileSync(file, 'utf8'));
  fs.rmSync(out, { recursive: true });
  return { code, exam };
}

// What the runtime wants of a page, in this realm: its objects are compared by their classes.
async function started(code) {
  const { window } = new JSDOM('<!doctype html><html><body></body></html>', { url: 'http://localhost/' });
  globalThis.window = globalThis;
  const wanted = ['document', 'DOMParser', 'XMLSerializer', 'XPathResult', 'XMLDocument', 'Document', 'Element', 'Node'];
  for (const name of [...wanted, 'HTMLElement', 'customElements', 'location', 'localStorage']) globalThis[name] ??= window[name];
  globalThis.addEventListener ??= () => {};
  globalThis.XSLTProcessor = class {
    importStylesheet() {}
    transformToDocument(container) {
      const made = document.implementation.createDocument(null, 'span');
      made.documentElement.append(...[...container.firstChild.childNodes].map((each) => made.importNode(each, true)));
      return made;
    }
  };
  vm.runInThisContext(code);
  const { Numbas } = globalThis;
  Numbas.queueScript('selectors', ['xml'], () => {
    for (const name of ['selectNodes', 'selectSingleNode']) window.Document.prototype[name] ??= window.XMLDocument.prototype[name];
  });
  await new Promise((done) => {
    Numbas.queueScript('go', ['start-exam', 'selectors'], () => {
      Numbas.locale.set_preferred_locale('en-GB');
      done();
    });
    Numbas.checkAllScriptsLoaded();
  });
  return Numbas;
}

// The questions of an exam by their names, all in one variant.
async function questions(Numbas, source, variant) {
  const fixed = source.replaceAll(/"definition": ?"random\(0\.\.\d+\)"/g, `"definition":"${variant}"`);
  const exam = await (await Numbas.load_exam({ exam_source: fixed, seed: '1' })).exam;
  await exam.signals.on('ready');
  await Promise.all(exam.questionList.map((each) => each.signals.on('ready')));
  return new Map(exam.questionList.map((each) => [each.name, each]));
}

const words = (markup) => {
  const element = document.createElement('div');
  element.innerHTML = markup;
  return element.textContent.replaceAll(/\s+/g, ' ').trim();
};

function submitted(part, response, written) {
  let answer = response;
  if (part.type === '1_n_2') answer = written.choices.map((choice) => [choice === response]);
  part.storeAnswer(answer);
  part.setStudentAnswer();
  part.submit();
  return { credit: part.credit, said: part.markingFeedback.map((each) => words(each.message ?? '')), warned: part.warnings };
}

function tried(question, written, test) {
  const start = performance.now();
  const found = { question: test.question, what: test.what, response: test.response, wanted: test.verdict === 'correct' };
  try {
    const n = question.parts.length;
    const given = n > 1 ? JSON.parse(test.response) : [test.response];
    const marked = question.parts.map((part, k) => submitted(part, given[k], written.parts[k]));
    found.credit = Math.min(...marked.map((each) => each.credit));
    found.said = !test.feedback || marked.some((each) => each.said.includes(words(test.feedback)));
    found.error = marked.flatMap((each) => each.warned).join('; ');
    found.passed = (found.credit === 1) === found.wanted && found.said && !found.error;
    if (!found.said) found.feedback = marked.flatMap((each) => each.said);
  } catch (error) {
    Object.assign(found, { passed: false, error: String(error.message) });
  }
  return { ...found, seconds: Math.round(performance.now() - start) / 1000 };
}

let Numbas;
const results = [];
const log = console.log;
console.log = console.error;
for (const folder of packages) {
  const { code, exam } = compiled(folder);
  Numbas ??= await started(code);
  const written = new Map();
  for (const group of JSON.parse(exam.replace(/^\/\/.*$/m, '')).question_groups)
    for (const each of group.questions) written.set(each.name, each);
  const { tests } = JSON.parse(fs.readFileSync(path.join(folder, 'selftests.json'), 'utf8'));
  const variants = new Map();
  const outcome = [];
  for (const test of tests) {
    const [name, n] = written.has(test.question) ? [test.question, 1] : test.question.split(/ #(?=\d+$)/);
    if (!variants.has(n)) variants.set(n, await questions(Numbas, exam, Number(n) - 1));
    outcome.push(tried(variants.get(n).get(name), written.get(name), test));
  }
  results.push({ package: path.basename(folder), tests: outcome });
}
process.stdout.write(JSON.stringify(results), () => process.exit(0));

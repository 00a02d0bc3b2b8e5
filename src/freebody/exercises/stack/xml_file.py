"""The file that Moodle imports: questions of the type stack, written and read back.

Source: qtype_stack, `questiontype.php` (`export_to_xml`, `import_from_xml`) and `api/util/StackQuestionLoader.php`.
"""

from __future__ import annotations

from base64 import b64decode, b64encode
from collections.abc import Iterator, Mapping
from html import escape
from typing import cast
from xml.etree.ElementTree import Element

from freebody.exercises.stack.question import Expected, Input, InputKind, Node, QuestionTest, StackQuestion, Tree
from freebody.exercises.xml import HEAD, parsed

VERSION = "2024012900"  # of STACK, from which on all is there that is used here
_INSERT_STARS = "4"  # for products side by side, and for spaces
_WITH_FILES = ("questiontext", "generalfeedback")
_OPTIONS = """\
<questionsimplify>1</questionsimplify>
<assumepositive>0</assumepositive>
<assumereal>1</assumereal>
<decimals>.</decimals>
<multiplicationsign>dot</multiplicationsign>
<sqrtsign>1</sqrtsign>
<complexno>i</complexno>
<inversetrig>acos</inversetrig>
<logicsymbol>lang</logicsymbol>
<matrixparens>(</matrixparens>
"""


# -- writing ----------------------------------------------------------------------------------
def quiz(category: str, questions: Mapping[str, StackQuestion] | tuple[StackQuestion, ...]) -> bytes:
    """The file. category: the folder of the question bank in which they are put."""
    listed = questions if isinstance(questions, tuple) else tuple(questions.values())
    head = f'<question type="category"><category>{_text(f"$course$/top/{category}")}</category></question>\n'
    body = head + "".join(map(_question, listed))
    return f"{HEAD}<quiz>\n{body}</quiz>\n".encode()


def _question(q: StackQuestion) -> str:
    feedback = "".join(f"[[feedback:{tree.name}]]" for tree in q.trees)
    parts = [
        f"<name>{_text(q.name)}</name>",
        f'<questiontext format="html">{_html(q.text)}\n{_files(q.files)}</questiontext>',
        f'<generalfeedback format="html">{_html(q.general)}\n{_files(q.solution_files)}</generalfeedback>',
        f"<defaultgrade>{q.grade:g}</defaultgrade>\n<penalty>0.1</penalty>\n<hidden>0</hidden>",
        f"<idnumber>{escape(q.id)}</idnumber>",
        f"<stackversion>{_text(VERSION)}</stackversion>",
        f"<questionvariables>{_text(q.variables)}</questionvariables>",
        f'<specificfeedback format="html">{_html(feedback)}</specificfeedback>',
        f'<questionnote format="html">{_html(q.note)}</questionnote>',
        _OPTIONS.rstrip(),
        *map(_input, q.inputs),
        *map(_tree, q.trees),
        *(f"<deployedseed>{seed}</deployedseed>" for seed in q.seeds),
        *(_test(k, test) for k, test in enumerate(q.tests, 1)),
    ]
    return '<question type="stack">\n' + "\n".join(parts) + "\n</question>\n"


def _files(files: Mapping[str, bytes] | None) -> str:
    return "".join(
        f'<file name="{escape(name)}" path="/" encoding="base64">{b64encode(content).decode()}</file>\n'
        for name, content in (files or {}).items()
    )


def _text(text: str) -> str:
    return f"<text>{escape(text, quote=False)}</text>"


def _html(text: str) -> str:
    """As it is written, which its readers like better than signs by name."""
    return f"<text><![CDATA[{text.replace(']]>', ']]]]><![CDATA[>')}]]></text>" if text else "<text></text>"


def _elements(**values: object) -> str:
    return "".join(f"<{name}>{escape(str(value), quote=False)}</{name}>" for name, value in values.items())


def _input(i: Input) -> str:
    shown = _elements(
        name=i.name,
        type=i.kind,
        tans=i.answer,
        boxsize=40 if i.kind == "algebraic" else 15,
        strictsyntax=1,
        insertstars=0 if i.kind == "radio" else _INSERT_STARS,
        syntaxhint="",
        syntaxattribute=0,
        forbidwords="",
        allowwords=",".join(i.words),
        forbidfloat=0,
        requirelowestterms=0,
        checkanswertype=0,
        mustverify=int(i.is_shown),
        showvalidation=int(i.is_shown),
        options=i.options,
    )
    return f"<input>{shown}</input>"


def _tree(tree: Tree) -> str:
    variables = f"<feedbackvariables>{_text(tree.variables)}</feedbackvariables>"
    head = _elements(name=tree.name, value=f"{tree.weight:g}", autosimplify=1, feedbackstyle=1)
    last = len(tree.nodes) - 1
    nodes = "".join(_node(tree, k, node, k == last) for k, node in enumerate(tree.nodes))
    return f"<prt>{head}{variables}\n{nodes}</prt>"


def _node(tree: Tree, k: int, node: Node, is_last: bool) -> str:
    test = _elements(
        name=k,
        description=node.note,
        answertest=node.test,
        sans=node.given,
        tans=node.wanted,
        testoptions=node.options,
        quiet=int(node.is_quiet),
    )
    agrees = _elements(
        truescoremode="=", truescore=int(node.is_right), truepenalty="", truenextnode=-1, trueanswernote=node.note
    )
    note = tree.missed() if is_last else f"{tree.name}-{k + 1}-F"
    differs = _elements(
        falsescoremode="=", falsescore=0, falsepenalty="", falsenextnode=-1 if is_last else k + 1, falseanswernote=note
    )
    said = f'<truefeedback format="html">{_html(node.feedback)}</truefeedback>'
    return f'<node>{test}{agrees}{said}{differs}<falsefeedback format="html"><text></text></falsefeedback></node>\n'


def _test(k: int, test: QuestionTest) -> str:
    typed = "".join(f"<testinput>{_elements(name=name, value=value)}</testinput>" for name, value in test.typed.items())
    expected = "".join(f"<expected>{_expected(tree, e)}</expected>" for tree, e in test.expected.items())
    return f"<qtest>{_elements(testcase=k, description=test.what)}{typed}{expected}</qtest>"


def _expected(tree: str, e: Expected) -> str:
    penalty = 0 if e.score == 1 else ""  # that of the question
    return _elements(name=tree, expectedscore=f"{e.score:g}", expectedpenalty=penalty, expectedanswernote=e.note)


# -- reading ----------------------------------------------------------------------------------
def questions_of(content: bytes, file: str) -> Iterator[StackQuestion]:
    """The questions of a file. Raises InputError for what is none."""
    root = parsed(content, file)
    for element in root.iter("question"):
        if element.get("type") == "stack":
            yield _read(element)


def _read(q: Element) -> StackQuestion:
    inputs = tuple(
        Input(
            _of(i, "name"),
            cast("InputKind", _of(i, "type")),
            _of(i, "tans"),
            tuple(filter(None, _of(i, "allowwords").split(","))),
            _of(i, "options"),
            _of(i, "mustverify") == "1",
        )
        for i in q.findall("input")
    )
    trees = tuple(
        Tree(
            _of(t, "name"),
            tuple(map(_read_node, t.findall("node"))),
            _of(t, "feedbackvariables/text"),
            float(_of(t, "value") or 1),
        )
        for t in q.findall("prt")
    )
    return StackQuestion(
        _of(q, "name/text"),
        _of(q, "questiontext/text"),
        _of(q, "generalfeedback/text"),
        _of(q, "questionvariables/text"),
        _of(q, "questionnote/text"),
        inputs,
        trees,
        tuple(int(seed.text or 0) for seed in q.findall("deployedseed")),
        tuple(map(_read_test, q.findall("qtest"))),
        *({f.get("name", ""): b64decode(f.text or "") for f in q.findall(f"{e}/file")} for e in _WITH_FILES),
        grade=float(_of(q, "defaultgrade") or 1),
        id=_of(q, "idnumber"),
    )


def _read_node(n: Element) -> Node:
    return Node(
        _of(n, "answertest"),
        _of(n, "sans"),
        _of(n, "tans"),
        _of(n, "trueanswernote"),
        _of(n, "truefeedback/text"),
        _of(n, "testoptions"),
        _of(n, "truescore") == "1",
        _of(n, "quiet") == "1",
    )


def _read_test(t: Element) -> QuestionTest:
    typed = {_of(i, "name"): _of(i, "value") for i in t.findall("testinput")}
    expected = {
        _of(e, "name"): Expected(float(_of(e, "expectedscore") or 0), _of(e, "expectedanswernote"))
        for e in t.findall("expected")
    }
    return QuestionTest(_of(t, "description"), typed, expected)


def _of(element: Element, path: str) -> str:
    found = element.find(path)
    return "" if found is None or found.text is None else found.text

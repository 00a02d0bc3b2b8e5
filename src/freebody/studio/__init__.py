"""The studio: a page in the browser in which a model is written, moved, asked and understood.

wire        what page and server say to each other: one schema, from which the types of the page are written
reading     a text as the page needs it: what is in it, where that stands, what is wrong and how to mend it
joining     what can be pointed at in the scene, and new elements between that
moving      its motion: what the player draws, curves, events
marking     where a condition of an answer changes along a slider
renaming    another name for a part of it, wherever the text has it
asking      pictures, studies, and files of them
work        the table of what a worker does
worker      the process that does it, with limits of time and memory
nursery     where workers come from: a process that has imported once what they need (`grown`), and forks
lanes       the workers as the server sees them: the latest request wins, one can be cancelled, a crash is a message
folder      the opened folder, beyond which the page reaches nothing
server      the address of the page, who may use it, and its answers
launch      the command
notebook    scene, time and sliders in a notebook, answered by its kernel (`widget.js` shows them)

The text of the model is the only state, and it is the page's: the server keeps none. The page itself is written in
`studio/` (TypeScript, Svelte) and built into `page/`, which is kept with the sources: users need no node.
"""
